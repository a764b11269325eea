/**
 * Reads lines outside of AAMA blocks: plain DXF, loose lines, and blocks without a boundary layer.
 * Every closed line is a piece and owns everything inside, unless its role is another.
 */
import {distance, type Point} from '../../model/geometry/vectors.js';
import {boxOf, isInside, signedArea, type Box} from '../../model/geometry/polyline.js';
import {closedLine, type Words} from '../base/closed-lines.js';
import {nearestOn} from '../../model/geometry/nearest.js';
import {cutOutNote, doubtOf, isNearlyClosed, leftOutNotes, mostDoubts} from '../base/left-out.js';
import {leastPiece, rolesOf, type Candidate, type Roles, type RolesOfPiece} from '../base/roles.js';
import {isNoName} from '../base/words.js';
import type {Drawn, PlacedBlock} from './blocks.js';
import {checkCount} from './count.js';
import type {LineEntity} from './entities.js';
import * as layers from './layers.js';
import {bySize, loopsOf, type Loop, type Loops} from './loops.js';
import {linesOf, pieceOf, type DxfPiece} from './pieces.js';

/** Greatest gap between the ends of lines. [cm] */
export const reach = 0.03;

/** Greatest distance of a mark outside its piece. [cm] */
const markReach = 1;

/** Share of the drawing's size at which ends meet before its unit is known. */
const roughReach = 2e-5;

interface FlatPiece extends RolesOfPiece<LoopLine> {
  readonly box: Box;
  readonly marked: Drawn[];
}

/** A closed line in millimetres, with its drawing. */
interface LoopLine extends Candidate {
  readonly loop: Loop;
  /** The outline of another block. */
  readonly isOther?: boolean;
}

export interface FlatDrawing {
  readonly cmPerUnit: number;
  /** Name of the block, and of the only piece without words. */
  readonly name?: string;
  /** Other blocks, whose pieces a frame may enclose. */
  readonly others?: readonly (readonly Drawn[])[];
  /** Numbers of copies as drawn and mirrored. Default one. */
  readonly inserted?: PlacedBlock['inserted'];
  /** File name for messages. */
  readonly file: string;
}

const once: PlacedBlock['inserted'] = {asDrawn: 1, mirrored: 0};

/** Greatest number of closed lines of 25 cm2 or more, pieces or not. */
const mostOutlines = 1000;
const outlineArea = 2500;

interface FlatPieces {
  readonly pieces: readonly DxfPiece[];
  readonly notes: readonly string[];
}

const sizeOf = (points: readonly Point[]): number => {
  const {low, high} = boxOf(points);
  return Math.max(high[0] - low[0], high[1] - low[1]);
};

/** The longer side of the largest closed line, or of the largest line if none closes. */
export function largestLine(entities: readonly Drawn[]): number {
  const lines = linesOf(entities);
  if (lines.length === 0) return 0;
  const whole = sizeOf(lines.flatMap(({points}) => points));
  const {closed, open} = loopsOf(lines, roughReach * whole || 1);
  const some = closed.length > 0 ? closed : open;
  return Math.max(0, ...some.map(({points}) => sizeOf(points)));
}

/**
 * Pieces of lines.
 * @throws {FileError} for more closed lines than a pattern has
 */
export function flatPieces(
  entities: readonly Drawn[],
  {cmPerUnit, name, others = [], inserted = once, file}: FlatDrawing,
): FlatPieces {
  const lines = linesOf(entities);
  const isLayered = lines.some(({layer}) => layer === layers.boundary || layer in layers.roles);
  const isOutline = (one: LineEntity): boolean =>
    !isLayered ||
    !layers.isMark(one.layer) ||
    (one.isClosed && !layers.holdsClosedMarks(one.layer));
  const {closed, open} = loopsByLayer(lines.filter(isOutline), isLayered, reach / cmPerUnit);
  const toMm = ([x, y]: Point): Point => [10 * cmPerUnit * x, 10 * cmPerUnit * y];
  const candidates = closed.map((loop): LoopLine => {
    const stated = isLayered ? layers.roles[loop.layer] : undefined;
    return {
      ...closedLine(loop.points.map(toMm)),
      ...(stated && {stated}),
      mayLieOver: true,
      ...{style: loop.layer, loop},
    };
  });
  checkCount(candidates.filter(({area}) => area >= outlineArea).length, file, mostOutlines);
  const words = entities.flatMap((one): Words[] =>
    one.kind === 'text' && one.text !== '' ? [{at: toMm(one.at), lines: [one.text]}] : [],
  );
  const elsewhere = others.flatMap((block): LoopLine[] => {
    const [loop] = bySize(loopsOf(linesOf(block), reach / cmPerUnit).closed);
    if (!loop) return [];
    const line = closedLine(loop.points.map(toMm));
    return [{...line, stated: 'piece', style: loop.layer, loop, isOther: true}];
  });
  const roles = rolesOf([...candidates, ...elsewhere], {
    words,
    open: open.map(({points}) => points.map(toMm)),
  });
  const own = roles.pieces.filter(({outline}) => outline.isOther !== true);
  const pieces = own.map((one): FlatPiece => ({
    ...one,
    box: boxOf(one.outline.loop.points),
    marked: [],
  }));
  const outside: Loops['open'][number][] = [];
  const marks: readonly Drawn[] = entities.filter((one) => one.kind !== 'line' || !isOutline(one));
  for (const mark of marks) ownerOf(pieces, mark, markReach / cmPerUnit)?.marked.push(mark);
  for (const chain of open) {
    const mark = inner(chain.points, false, isLayered ? chain.layer : undefined);
    // an outline that does not close is no mark of the piece beside it
    const points = chain.points.map(toMm);
    const isOpenOutline = Math.abs(signedArea(points)) >= outlineArea;
    const owner = ownerOf(pieces, mark, isOpenOutline ? 0 : markReach / cmPerUnit);
    owner?.marked.push(mark);
    if (!owner || (isOpenOutline && isNearlyClosed(points))) outside.push(chain);
  }
  const found = pieces.map((one, k) => {
    const called = name !== undefined && pieces.length === 1 ? name : `piece ${String(k + 1)}`;
    return asPiece(one, called, inserted);
  });
  return {
    pieces: [...found, ...doubtsIn(roles)],
    notes: [
      ...pieces.flatMap(({doubtfulCutOuts}, k) => {
        return cutOutNote(found[k]?.name ?? '', doubtfulCutOuts, 'up') ?? [];
      }),
      ...leftOutNotes(roles, {
        layerOf: (line) => (line as LoopLine).loop.layer,
        axis: 'up',
        open: outside.map(({points, layer}) => ({points: points.map(toMm), layer})),
      }),
    ],
  };
}

/** Lines that may be pieces. */
function doubtsIn({asides, nested}: Roles<LoopLine>): DxfPiece[] {
  return [...asides, ...nested]
    .filter(({area}) => area >= leastPiece)
    .slice(0, mostDoubts)
    .map((line): DxfPiece => {
      const {name, reason} = doubtOf(line, nested.includes(line), line.loop.layer, 'up');
      const block = {name, entities: [], inserted: once};
      return {
        ...pieceOf(block),
        loops: [{...line.loop, layer: layers.boundary}],
        doubt: reason,
      };
    });
}

/** Lines of layered files close within their layer. */
function loopsByLayer(lines: readonly LineEntity[], isLayered: boolean, gap: number): Loops {
  if (!isLayered) return loopsOf(lines, gap);
  const names = [...new Set(lines.map(({layer}) => layer))];
  const all = names.map((one) =>
    loopsOf(
      lines.filter(({layer}) => layer === one),
      gap,
    ),
  );
  return {
    closed: all.flatMap(({closed}) => closed),
    open: all.flatMap(({open}) => open),
  };
}

const inner = (points: readonly Point[], isClosed: boolean, layer?: string): Drawn => ({
  ...{kind: 'line', layer: layer === layers.cutOut ? layer : layers.internalLine},
  ...{points, isClosed},
});

/** The smallest piece that contains a mark, otherwise a nearby piece. */
function ownerOf(
  pieces: readonly FlatPiece[],
  mark: Drawn,
  reachable: number,
): FlatPiece | undefined {
  const at = mark.kind === 'line' ? mark.points[Math.floor(mark.points.length / 2)] : mark.at;
  if (!at) return undefined;
  const near = pieces.filter(({box: {low, high}}) =>
    [0, 1].every((axis) => {
      const x = at[axis] ?? 0;
      return x >= (low[axis] ?? 0) - reachable && x <= (high[axis] ?? 0) + reachable;
    }),
  );
  const around = near
    .filter(({outline}) => isInside(outline.loop.points, at))
    .sort((a, b) => a.outline.area - b.outline.area)[0];
  if (around) return around;
  return near.find(
    ({outline: {loop}}) => distance(nearestOn(loop.points, at, true).at, at) <= reachable,
  );
}

/** A piece in the structure of a file with blocks. */
function asPiece(
  {outline, sewn, cutOuts, doubtfulCutOuts, marks, marked}: FlatPiece,
  name: string,
  inserted: PlacedBlock['inserted'],
): DxfPiece {
  const texts = marked.flatMap((mark) => (mark.kind === 'text' ? [mark.text] : []));
  const named = texts.find((text) => !isNoName(text)) ?? texts.find(isLetter);
  const onLayer = ({loop}: LoopLine, layer: string): Loop => ({...loop, layer});
  return {
    ...pieceOf({
      name: named ?? name,
      entities: [...marks.map(({loop}) => inner(loop.points, true)), ...marked],
      inserted,
    }),
    loops: [
      onLayer(outline, layers.boundary),
      ...(sewn ? [onLayer(sewn, layers.sewLine)] : []),
      ...cutOuts.map((one) => ({
        ...onLayer(one, layers.cutOut),
        isDoubtful: doubtfulCutOuts.includes(one),
      })),
    ],
  };
}

/** Returns whether a text is a letter with or without a number, as short names are. */
const isLetter = (text: string): boolean => /^\p{L}\d{0,3}$/u.test(text);
