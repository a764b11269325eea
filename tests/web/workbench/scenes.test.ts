import {expect, it} from 'vitest';

import {en} from '@/texts/en.js';
import {SceneMaker} from '@/workbench/scenes.js';
import type {Design} from '@/model/design/design.js';
import type {MeshedPattern} from '@/model/result/result.js';
import {documentOf} from '../../support/garments/documents.js';
import {squarePair, squarePiece} from '../../support/garments/two-squares.js';

const design: Design = {
  garment: {name: 'strips.json', text: '{}'},
  print: {
    ...{title: '', group: 'p1', turnDeg: 0, oneWay: false, cell: 'primitive', image: ''},
    size: {width: 10, height: 10, angleDeg: 90},
  },
  ...{symmetry: 'none', seed: 1, method: 'best', options: {}},
};

/** A row of squares as drafted, each sewn to the next and aligned slightly higher. */
function row(): MeshedPattern {
  const {print, symmetries, seams} = squarePair();
  const pieces = Array.from({length: 9}, (_, k) => ({
    ...squarePiece(`piece ${k}`, {
      alignment: {angle: 0, translation: [-4 * k, (0.1 * k * (k + 1)) / 2]},
    }),
    edges: [0, 1, 2, 3],
  }));
  const [seam] = seams;
  if (!seam) throw new Error('no seam');
  const joined = pieces.slice(1).map((_, k) => ({
    ...seam,
    a: {piece: k, vertices: [1, 2]},
    b: {piece: k + 1, vertices: [0, 3]},
  }));
  return {...{print, symmetries, pieces, seams: joined}, fitRandom: 0, notes: []};
}

it('shows the same figures before in every window', () => {
  const pattern = row();
  const garment = documentOf([]);
  const workbench = {
    history: {design},
    solving: {garment, pattern, result: undefined},
    running: {partial: undefined},
    preferences: {chosen: {scale: 'absolute'}, texts: en},
  } as const;
  const all = [390, 820, 1280, 2560].map((width) =>
    new SceneMaker().scenes(workbench, {width, height: 800}),
  );
  const offsets = all.map((scenes) => JSON.stringify(scenes?.before.pieces.map((p) => p.offset)));
  expect(new Set(offsets).size).toBeGreaterThan(1);
  for (const scenes of all) {
    scenes?.before.seams.forEach(({mean}, k) => {
      expect(mean).toBeCloseTo(0.1 * (k + 1), 9);
    });
  }
});
