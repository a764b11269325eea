/** Checks the documents that functions of `seamwise/node` take as objects. */
import {either, fields, having, optional} from '../model/base/arguments.js';
import {groupNames} from '../model/base/core-tables.js';
import {
  fail,
  flag,
  list,
  listOf,
  number,
  oneOf,
  pairOf,
  recordOf,
  text,
  wholeNumber,
  type Read,
} from '../model/base/read.js';
import type {CutSheet} from '../cutting/cut-sheet.js';
import type {MarkerGarment} from '../model/design/marker-garment.js';
import {checkedResult} from '../model/documents/checked-result.js';
import type {FiledDesign} from '../model/documents/filed-design.js';
import type {GarmentDocument} from '../model/garment/garment-document.js';
import {norm, type Point} from '../model/geometry/vectors.js';
import {scaleLimits} from '../model/print/print-scale.js';
import {mostTurn} from '../model/print/print-variant.js';
import {printCells, type Delivered, type Print} from '../model/print/repeating-print.js';
import type {Drape} from '../model/result/draped-garment.js';
import {layNoteCodes, type LayNote} from '../model/result/lay-note.js';
import type {LayPlan} from '../model/result/marker-plan.js';
import type {Problem} from '../model/design/solve-problem.js';
import type {PrintWithTile} from '../picture/fabric.js';

/** [cm] */
const finite = number(-1e9, 1e9);
const point: Read<Point> = pairOf(finite);
const points = listOf(point);

/** Length or coordinate on a sheet or a bolt of at most a kilometre. [cm] */
const length = number(-1e5, 1e5);
const place: Read<Point> = pairOf(length);
const places = listOf(place);

/** Shortest and longest repeat of a print, as in the core. [cm] */
const repeatLimits = [0.05, 1000] as const;

const repeat: Read<Point> = (value, at) => {
  const vector = point(value, at);
  const length = norm(vector);
  const [least, most] = repeatLimits;
  return length >= least * (1 - 1e-9) && length <= most * (1 + 1e-9)
    ? vector
    : fail(at, `a vector of ${least} to ${most} cm`);
};

const share = optional(finite);

const delivered: Read<Delivered> = having<Delivered>({
  shrinkage: optional(having({warp: share, weft: share})),
  measured: optional(having({across: share, up: share})),
});

/** Accepts a print with its tile; fields of other programs are allowed. */
export const print: Read<PrintWithTile> = having<Print & {readonly tile?: string}>({
  ...{group: oneOf(groupNames), w1: repeat, w2: repeat},
  ...{image: optional(text()), tile: optional(text()), title: optional(text())},
  ...{oneWay: optional(flag), unscaled: optional(flag), cell: optional(oneOf(printCells))},
  ...{scale: optional(number(...scaleLimits)), turnDeg: optional(number(-mostTurn, mostTurn))},
  ...{fabric: optional(delivered), delivered: optional(delivered)},
  colourways: optional(listOf(having({name: text(), image: text()}))),
});

const edge = having({points});

export const garmentDocument: Read<GarmentDocument> = having<GarmentDocument>({
  pieces: listOf(
    having({
      ...{name: text(), outline: listOf(edge), holes: listOf(listOf(edge))},
      ...{internalLines: listOf(points), quantity: optional(number(0, 1e6))},
      ...{cutLine: optional(points), sewLine: optional(points), drillHoles: optional(points)},
      ...{label: optional(text()), size: optional(text()), material: optional(text())},
    }),
  ),
  ...{seams: list, matches: list, symmetries: list, questions: list},
  ...{title: optional(text()), size: optional(text())},
});

/** Accepts a sheet of `cut`. */
export const cutSheet: Read<CutSheet> = having<CutSheet>({
  ...{widthCm: length, heightCm: length, heading: text(), facts: listOf(text())},
  ...{size: optional(text()), ownAllowances: text()},
  pieces: listOf(
    having({
      ...{name: text(), label: text(), quantity: finite, words: listOf(text())},
      ...{cut: listOf(places), sewn: listOf(places), internalLines: listOf(places)},
      ...{corners: places, drillHoles: places, grain: pairOf(place)},
      ...{matchPoints: listOf(having({at: place})), ticks: listOf(having({at: place}))},
      ...{notches: listOf(having({at: place})), letters: listOf(having({at: place}))},
      ...{folds: list, marks: listOf(having({kind: oneOf(['line', 'text'])}))},
    }),
  ),
});

const markerGarment: Read<MarkerGarment> = fields<MarkerGarment>(
  {
    ...{result: checkedResult, name: text(), garment: garmentDocument, options: having({})},
    copies: wholeNumber,
    ...{names: recordOf(text()), problem: having<Problem>({}), others: list},
  },
  'result',
);

/** Accepts a result, or one with its sources. */
export const laidGarment: Read<unknown> = (value, at) =>
  typeof value === 'object' && value !== null && 'result' in value
    ? markerGarment(value, at)
    : checkedResult(value, at);

const nothing: Read<null> = (value, at) => (value === null ? value : fail(at, 'null'));

/** A length, or null where it is unknown. */
export const numberOrNull = either('a number or null', finite, nothing);
const lengthOrNull = either('a length or null', length, nothing);

const laidPiece = {
  result: wholeNumber,
  copy: wholeNumber,
  piece: text(),
  nth: optional(wholeNumber),
};

const layNote = having<LayNote>({
  ...{
    code: oneOf(layNoteCodes),
    pieces: listOf(text()),
    lengthsCm: listOf(length),
    counts: listOf(finite),
  },
});

export const layPlan: Read<LayPlan> = having<LayPlan>({
  print: having({group: oneOf(groupNames), w1: repeat, w2: repeat}),
  ...{widthCm: length, selvedgeCm: length, gapCm: length, allowanceCm: length, lengthCm: length},
  ...{hemCm: optional(length), foldCm: optional(length), useShare: finite, boundCm: finite},
  ...{proven: flag, freeLengthCm: lengthOrNull, unpinnedLengthCm: optional(lengthOrNull)},
  printOrigin: either('a point or null', place, nothing),
  placements: listOf(having({...laidPiece, cut: places, angle: finite, translation: place})),
  unplaced: listOf(having(laidPiece)),
  garments: optional(listOf(having({result: wholeNumber, copies: finite, lengthCm: length}))),
  phases: listOf(having({phaseCm: length, lengthCm: lengthOrNull})),
  widths: listOf(having({widthCm: length, lengthCm: lengthOrNull})),
  cheaper: listOf(having({kind: text(), lengthCm: length, pieces: optional(listOf(text()))})),
  ...{notes: listOf(text()), noteDetails: listOf(layNote)},
});

export const drape: Read<Drape> = having<Drape>({
  mesh: having({pieces: listOf(having({})), seams: list, mirrors: list}),
  positions: (value, at) =>
    value instanceof Float64Array ? value : fail(at, 'a Float64Array of coordinates'),
  form: having({parts: list, surface: having({})}),
  ...{fabric: having({offset: finite}), stages: list, check: having({}), notes: list},
});

const storedFile = having({url: text(), sha256: text()});

export const filedDesign: Read<FiledDesign> = having<FiledDesign>({
  ...{garment: storedFile, print: storedFile},
});
