/** Checks every value of a design from outside, so that the rest of the page can trust it. */
import type {GrainRule} from '../garment/grain.js';
import {groupNames, optionLimits} from '../base/core-tables.js';
import {
  askingFor,
  mostAdded,
  mostCopies,
  type AddedGarment,
  type AskedSymmetry,
  type Decisions,
  type Design,
} from './design.js';
import type {Alignment, Point} from '../geometry/vectors.js';
import type {Lock, SolveOptions} from './options.js';
import {fabricNames} from '../result/draped-garment.js';
import {printCells} from '../print/repeating-print.js';
import {methods} from '../result/method.js';
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
} from '../base/read.js';
import type {Symmetry} from '../garment/symmetries.js';
import {tileRepeats, type PrintTile} from '../print/opened-image.js';
import {heldOf} from './written-design.js';

/** The solver's limits for the sides of a repeat; the limits below exceed any garment. [cm] */
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

/** Short enough to be printed on a piece. */
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
    visibility: oneOf(['place', 'even']),
    effort: number(...optionLimits.effort),
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

/** Reads an empty list as `none`. */
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

const {size, turnDeg} = repeatFields;

const percent = number(-50, 50);
/** Values of fabric as delivered. */
export const fabricFields = {
  shrinkage: shape({warp: percent, weft: percent}),
  measured: shape({}, {across: repeat, up: repeat}),
};
const {group, cell} = repeatFields;

/** The repeat of a print, without its image. */
export const printMeasures = shape(repeatFields, {
  delivered: shape({stated: shape({group, size, turnDeg, cell})}, fabricFields),
  ...{unscaled: flag, isPrinted: flag},
  own: shape({size, turnDeg}),
});

/** Decisions that a file may omit. */
export const optionalFields = {names: recordOf(pieceName), fabric: oneOf(fabricNames)};

/** Decisions that all files write alike. */
export const decisionFields = {method: oneOf(methods), options};

const writtenDecisions = shape(
  {symmetries: askedSymmetry, ...decisionFields},
  {seed, ...optionalFields},
);

/** Reads decisions in the form that `written` gives them. */
export const decisions: Read<Decisions> = (value, at) => {
  const {symmetries, ...others} = writtenDecisions(value, at);
  return heldOf({...others, ...(symmetries !== 'none' && {symmetries})});
};

const isOwnPicture = (source: string): boolean => /^data:image\/[\w.+-]+[;,]/.test(source);

/** An image embedded in the file. */
export const ownPicture: Read<string> = (value, at) => {
  const source = text()(value, at);
  return isOwnPicture(source) ? source : fail(at, 'a data: URL of an image');
};

/**
 * An image is embedded in the file or belongs to a sample: a file must not make the page send
 * requests to another host.
 */
const picture: Read<string> = (value, at) => {
  const source = text()(value, at);
  const isOwn = isOwnPicture(source);
  const isSample = /^[\w-]+(\/[\w-]+)*(\.[\w-]+)?$/.test(source);
  return isOwn || isSample ? source : fail(at, 'a data: URL of an image, or the path of a sample');
};

const quarterTurn: Read<0 | 90> = (value, at) =>
  value === 0 || value === 90 ? value : fail(at, '0 or 90');

const tileFields = {repeat: oneOf(tileRepeats), turnedDeg: quarterTurn};

/** The user's own image as opened, embedded in the file. */
export const ownTile: Read<PrintTile> = shape({image: ownPicture, ...tileFields});

const garmentFile = {
  name: text(/^.{1,255}$/su, 'a name'),
  text: text(/\S/, 'the text of a garment file'),
};
/** A garment with its text. */
export const ownGarment = shape(garmentFile);
const garment = shape(garmentFile, {sample: garmentSample});
const picturedPrint = shape(
  {title: text(), image: picture},
  {
    sample: printSample,
    tile: shape({image: picture, ...tileFields}),
  },
);

const copies: Read<number> = (value, at) =>
  Number.isInteger(value) && Number(value) >= 1 && Number(value) <= mostCopies
    ? Number(value)
    : fail(at, `a whole number from 1 to ${mostCopies}`);

/** Number of garments of a design, and the other garments on its fabric. */
export const onFabric = <Garment>(
  readGarment: Read<Garment>,
): Read<{
  readonly copies?: number;
  readonly added?: readonly AddedGarment<Garment>[];
}> => {
  const list: Read<readonly AddedGarment<Garment>[]> = (value, at) => {
    const all = listOf(
      shape(
        {garment: readGarment, symmetry: askedSymmetry, ...decisionFields, seed, copies},
        optionalFields,
      ),
    )(value, at);
    return all.length <= mostAdded ? all : fail(at, `at most ${mostAdded} garments`);
  };
  return shape({}, {copies, added: list});
};

export const readDesign: Read<Design> = (value, at) => {
  const {garment: own, print} = shape({
    garment,
    print: (entry, place) => ({...printMeasures(entry, place), ...picturedPrint(entry, place)}),
  })(value, at);
  return {garment: own, print, ...decisions(value, at), ...onFabric(garment)(value, at)};
};
