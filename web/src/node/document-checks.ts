/** Checks the documents that functions of `seamwise/node` take as objects. */
import {bytes, either, fields, having, optional} from '../model/base/arguments.js';
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
import type {FiledDesign} from '../model/documents/stored-design.js';
import type {GarmentDocument} from '../model/garment/garment-document.js';
import {norm, type Point} from '../model/geometry/vectors.js';
import type {PhotoPixels} from '../model/print/photo-reading.js';
import {scaleLimits} from '../model/print/print-scale.js';
import {mostTurn} from '../model/print/print-variant.js';
import {printCells, type Print} from '../model/print/repeating-print.js';
import type {Drape} from '../model/result/draped-garment.js';
import type {LayPlan} from '../model/result/marker-plan.js';
import type {Problem} from '../model/design/solve-problem.js';
import type {PrintWithTile} from '../picture/fabric.js';

/** [cm] */
const finite = number(-1e9, 1e9);
const point: Read<Point> = pairOf(finite);
const points = listOf(point);

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

/** Accepts a print with its tile; fields of other programs are allowed. */
export const print: Read<PrintWithTile> = having<Print & {readonly tile?: string}>({
  ...{group: oneOf(groupNames), w1: repeat, w2: repeat},
  ...{image: optional(text()), tile: optional(text()), title: optional(text())},
  ...{oneWay: optional(flag), unscaled: optional(flag), cell: optional(oneOf(printCells))},
  ...{scale: optional(number(...scaleLimits)), turnDeg: optional(number(-mostTurn, mostTurn))},
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
  ...{widthCm: finite, heightCm: finite, heading: text(), facts: listOf(text())},
  ...{size: optional(text()), ownAllowances: text()},
  pieces: listOf(
    having({
      ...{name: text(), label: text(), quantity: finite, words: listOf(text())},
      ...{cut: listOf(points), sewn: listOf(points), internalLines: listOf(points)},
      ...{corners: points, drillHoles: points, grain: pairOf(point)},
      ...{matchPoints: listOf(having({at: point})), ticks: listOf(having({at: point}))},
      ...{notches: listOf(having({at: point})), letters: listOf(having({at: point}))},
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

export const layPlan: Read<LayPlan> = having<LayPlan>({
  print: having({group: oneOf(groupNames), w1: repeat, w2: repeat}),
  ...{widthCm: finite, selvedgeCm: finite, gapCm: finite, allowanceCm: finite, lengthCm: finite},
  placements: listOf(
    having({
      ...{result: wholeNumber, copy: wholeNumber, piece: text(), cut: points},
      ...{angle: finite, translation: point},
    }),
  ),
  ...{unplaced: list, phases: list, widths: list, cheaper: list, notes: list},
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

const clamped: Read<unknown> = (value, at) =>
  value instanceof Uint8ClampedArray ? value : fail(at, 'a Uint8ClampedArray');

export const pixels: Read<PhotoPixels> = (value, at) => {
  const side = number(1, 1e6);
  const {width, height, data} = fields<PhotoPixels>(
    {
      ...{width: side, height: side},
      data: either('a Uint8Array or Uint8ClampedArray', bytes, clamped),
    },
    ...(['width', 'height', 'data'] as const),
  )(value, at);
  if (data.length !== 4 * width * height) fail(`${at}.data`, `${4 * width * height} bytes long`);
  return {width, height, data};
};
