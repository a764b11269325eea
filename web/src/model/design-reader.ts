/** Designs that come from outside: each value is checked, so that the rest of the page may trust it. */
import {optionLimits} from './core-tables.js';
import {askingFor, type AskedSymmetry, type Decisions, type Design} from './design.js';
import type {Alignment, Point} from './geometry.js';
import type {GrainRule, Lock, SolveOptions} from './options.js';
import {fabricNames} from './drape.js';
import {groupNames, printCells} from './print.js';
import {methods} from './method.js';
import {
  fail,
  flag,
  listOf,
  number,
  oneOf,
  pairOf,
  recordOf,
  shape,
  text,
  wholeNumber,
  type Read,
} from './read.js';
import type {Symmetry} from './symmetries.js';
import {tileRepeats, type PrintTile} from './print-tile.js';
import {heldOf} from './written-design.js';

/** What the solver takes for the sides of a repeat, and more than any garment measures. [cm] */
const repeat = number(...optionLimits.repeatCm);
const length = number(-10_000, 10_000);
const point: Read<Point> = pairOf(length);
const fileStem = text(/^[\w-]{1,80}$/, 'the name of a sample');
const locks = oneOf(['free', 'on', 'across', 'bias']);
const degrees = number(...optionLimits.toleranceDeg);

export const readAlignment: Read<Alignment> = shape({
  angle: number(-1000, 1000),
  translation: point,
});

const grainRule: Read<GrainRule> = (value, at) =>
  typeof value === 'string'
    ? locks(value, at)
    : shape({}, {lock: locks, toleranceDeg: degrees, angleDeg: number(-360, 360)})(value, at);

/** Few enough characters to stand on a piece. */
const pieceName = text(/^\P{Cc}{1,80}$/u, 'a name of at most 80 characters');

const markedLine = shape({piece: text(), line: listOf(point)});

const lock: Read<Lock> = (value, at) => (value === true ? value : listOf(wholeNumber)(value, at));

const options: Read<SolveOptions> = shape(
  {},
  {
    maxChangeCm: number(...optionLimits.maxChangeCm),
    alpha: number(...optionLimits.alpha),
    edgeLengthCm: number(...optionLimits.edgeLengthCm),
    continuousOnly: flag,
    averageSeamShapes: flag,
    starts: wholeNumber,
    clipTargets: flag,
    grain: shape({}, {default: locks, toleranceDeg: degrees, pieces: recordOf(grainRule)}),
    pins: recordOf(readAlignment),
    weights: recordOf(number(...optionLimits.weight)),
    unmatched: listOf(wholeNumber),
    plain: listOf(text()),
    matches: listOf(
      shape({a: markedLine, b: markedLine}, {weight: number(...optionLimits.weight)}),
    ),
    locked: recordOf(lock),
    openEdges: oneOf(['kept', 'free']),
    proof: number(...optionLimits.proof),
  },
);

const symmetry: Read<Symmetry> = (value, at) => {
  const {kind} = shape({kind: oneOf(['piece', 'pair'])})(value, at);
  if (kind === 'pair') return {kind, ...shape({pieces: pairOf(text())})(value, at)};
  const optional = {axis: pairOf(point), seams: pairOf(wholeNumber)};
  return {kind, ...shape({piece: text()}, optional)(value, at)};
};

export const symmetryList = listOf(symmetry);

/** An empty list is `none`. */
export const askedSymmetry: Read<AskedSymmetry> = (value, at) =>
  Array.isArray(value)
    ? askingFor(symmetryList(value, at))
    : typeof value === 'string'
      ? oneOf(['auto', 'none'])(value, at)
      : fail(at, "'auto', 'none' or a list of symmetries");

export const seed: Read<number> = (value, at) =>
  Number.isInteger(value) && Number(value) >= 0 && Number(value) <= 0xffffffff
    ? Number(value)
    : fail(at, 'a whole number from 0 to 4294967295');

export const garmentSample = shape({style: fileStem, size: fileStem});
export const printSample = shape({name: fileStem, colourway: text()});

/** The fields of a print's repeat. */
export const repeatFields = {
  group: oneOf(groupNames),
  size: shape({width: repeat, height: repeat, angleDeg: number(1, 179)}),
  turnDeg: number(-360, 360),
  oneWay: flag,
  cell: oneOf(printCells),
};

/** The repeat of a print, without its picture. */
export const printMeasures = shape(repeatFields, {unscaled: flag});

/** Decisions that a file may leave out. */
export const optionalFields = {names: recordOf(pieceName), fabric: oneOf(fabricNames)};

/** Those of the decisions that all files write alike. */
export const decisionFields = {method: oneOf(methods), options};

const writtenDecisions = shape(
  {symmetries: askedSymmetry, ...decisionFields},
  {seed, ...optionalFields},
);

/** As `written` writes them. */
export const decisions: Read<Decisions> = (value, at) => {
  const {symmetries, ...others} = writtenDecisions(value, at);
  return heldOf({...others, ...(symmetries !== 'none' && {symmetries})});
};

const isOwnPicture = (source: string): boolean => /^data:image\/[\w.+-]+[;,]/.test(source);

/** A picture in the file itself. */
export const ownPicture: Read<string> = (value, at) => {
  const source = text()(value, at);
  return isOwnPicture(source) ? source : fail(at, 'a data: URL of an image');
};

/** Pictures lie in the file itself or are those of a sample: no file may make the page ask another host. */
const picture: Read<string> = (value, at) => {
  const source = text()(value, at);
  const isOwn = isOwnPicture(source);
  const isSample = /^[\w-]+(\/[\w-]+)*(\.[\w-]+)?$/.test(source);
  return isOwn || isSample ? source : fail(at, 'a data: URL of an image, or the path of a sample');
};

const quarterTurn: Read<0 | 90> = (value, at) =>
  value === 0 || value === 90 ? value : fail(at, '0 or 90');

const tileFields = {repeat: oneOf(tileRepeats), turnedDeg: quarterTurn};

/** A picture of one's own as it was opened, in the file itself. */
export const ownTile: Read<PrintTile> = shape({image: ownPicture, ...tileFields});

const garmentFile = {
  name: text(/^.{1,255}$/su, 'a name'),
  text: text(/\S/, 'the text of a garment file'),
};
/** A garment that comes with its text. */
export const ownGarment = shape(garmentFile);
const garment = shape(garmentFile, {sample: garmentSample});
const picturedPrint = shape(
  {title: text(), image: picture},
  {
    sample: printSample,
    tile: shape({image: picture, ...tileFields}),
  },
);

export const readDesign: Read<Design> = (value, at) => {
  const {garment: own, print} = shape({
    garment,
    print: (entry, place) => ({...printMeasures(entry, place), ...picturedPrint(entry, place)}),
  })(value, at);
  return {garment: own, print, ...decisions(value, at)};
};
