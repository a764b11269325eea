import {describe, expect, it} from 'vitest';

import type {Placement} from '@/model/garment/garment-document.js';
import type {PanelMarks} from '@/model/garment/panel-marks.js';
import type {MeshedPattern, Pattern} from '@/model/result/result.js';
import type {DetectedSymmetry} from '@/model/garment/symmetries.js';
import {centred, middleToCentre} from '@/workbench/tools/centring.js';
import {sceneOf} from '@/scene/scene.js';
import type {Target} from '@/workbench/workbench.js';
import {plainPrint, squarePair} from '../../../support/garments/two-squares.js';

/**
 * The halves of a front, 4 cm wide each: x = 4 of the left one is sewn to x = 0 of the right one.
 */
const halves: DetectedSymmetry = {
  kind: 'pair',
  pieces: ['left_half', 'right_half'],
  ...{residual: 0, map: {angle: 0, translation: [4, 0]}},
};

function middle(
  pattern: Pattern,
  {
    selected,
    found = [],
    placements = {},
  }: {
    readonly selected?: Target;
    readonly found?: readonly DetectedSymmetry[];
    readonly placements?: Readonly<Record<string, Placement>>;
  } = {},
): unknown {
  const now = sceneOf(pattern, plainPrint);
  const marks = new Map(
    Object.entries(placements).map(([label, placement]): [string, PanelMarks] => [
      label,
      {label, placement},
    ]),
  );
  const pieces = pattern.pieces.map((piece) => ({...piece, edges: []}));
  const meshed: MeshedPattern = {...pattern, pieces, fitRandom: 1, notes: []};
  const scenes = {before: now, now, marks};
  const at = middleToCentre({
    selection: {selected},
    sheet: {scenes},
    solving: {pattern: meshed, found},
  });
  return at && {piece: at.piece.name, at: at.at};
}

describe('the place that a motif is centred on', () => {
  const right: Target = {kind: 'piece', piece: 1};

  it('is the middle of a piece that stands for itself', () => {
    expect(middle(squarePair())).toEqual({piece: 'left_half', at: [2, 2]});
    expect(middle(squarePair(), {selected: right})).toEqual({piece: 'right_half', at: [2, 2]});
  });

  it('is the seam between the halves of a body', () => {
    const found = [halves];
    expect(middle(squarePair(), {found})).toEqual({piece: 'left_half', at: [4, 2]});
    expect(middle(squarePair(), {found, selected: right})).toEqual({
      ...{piece: 'right_half', at: [0, 2]},
    });
  });

  it('is the middle of the body where its halves are not sewn together', () => {
    const open = squarePair({seams: []});
    const placed = {
      left_half: {translation: [-4.5, 100, 20]},
      right_half: {translation: [0.5, 100, 20]},
    } as const;
    const asked = {found: [halves], placements: placed};
    expect(middle(open, asked)).toEqual({piece: 'left_half', at: [4.5, 2]});
    expect(middle(open, {...asked, selected: right})).toEqual({piece: 'right_half', at: [-0.5, 2]});
    const sleeves = {left_half: {translation: [-40, 100, 0]}} as const;
    expect(middle(open, {found: [halves], placements: sleeves})).toMatchObject({at: [2, 2]});
  });

  it('is the axis of a piece that is symmetric in itself', () => {
    const own: DetectedSymmetry = {
      kind: 'piece',
      piece: 'left_half',
      ...{residual: 0, map: {angle: 0, translation: [3, 0]}},
    };
    expect(middle(squarePair(), {found: [own]})).toMatchObject({
      at: [expect.closeTo(1.5, 9) as number, 2],
    });
  });

  it('is the middle of an edge that is chosen', () => {
    const selected: Target = {kind: 'seam', seam: 0, side: 'b'};
    expect(middle(squarePair(), {selected})).toEqual({piece: 'right_half', at: [0, 2]});
  });
});

it('puts the print upright on the sheet, also on a piece that was turned for it', () => {
  const [piece] = sceneOf(squarePair(), plainPrint).pieces;
  if (!piece) throw new Error('There is no piece.');
  const at = [1, 3] as const;
  expect(centred({piece, at}, 'motif')).toEqual({angle: 0, translation: [1, 3]});
  expect(centred({piece, at}, 'line')).toEqual({angle: 0, translation: [1, 0]});
  expect(centred({piece: {...piece, isTurned: true}, at}, 'motif').angle).toBe(Math.PI);
});
