/** Reads prints from images, in slices. */
import {groupNames} from '../../model/base/core-tables.js';
import {vectorsAtMiddle} from '../../model/print/photo-map.js';
import {
  oneRepeat,
  photoConfidences,
  photoNotes,
  photoStages,
  symmetryVerdicts,
  type ColourGains,
  type Homography,
  type OpenEdge,
  type PhotoGroup,
  type PhotoHooks,
  type PhotoMap,
  type PhotoObject,
  type PhotoObjectSettings,
  type PhotoPixels,
  type PhotoReading,
  type PhotoSettings,
  type PhotoTileSettings,
  type Side,
  type TileSeams,
} from '../../model/print/photo-reading.js';
import type {Point} from '../../model/geometry/vectors.js';
import {runInSlices, stepsFor, type Pace} from './slices.js';
import type {
  ModuleObject,
  ModuleObjectRequest,
  ModulePhotoGroup,
  ModulePhotoReport,
  ModulePhotoRequest,
  ModulePhotoTileRequest,
  ModulePictureWork,
  ModuleTile,
  ModuleTileSeams,
} from '../module/photo.mjs';
import type {ModuleFailure} from '../module/module.js';
import {toError} from '../json/document.js';
import {SolverError} from '../../model/base/failure.js';
import {codedOf, linearOf} from '../../model/print/srgb.js';

// Decodes an image to upright pixels, on the thread that answers the request.

/** Larger images are reduced: finer detail does not help, and phones lack the memory. [px] */
const longestSide = 4096;

/** Pixels of an image. @throws {SolverError} for an image that cannot be decoded */
export async function decoded(picture: PhotoPixels | Blob): Promise<PhotoPixels> {
  if (!(picture instanceof Blob)) return picture;
  const bitmap = await bitmapOf(picture);
  try {
    const {width, height} = bitmap;
    const scale = Math.min(1, longestSide / Math.max(width, height));
    const [across, down] = [Math.round(scale * width), Math.round(scale * height)];
    const context = new OffscreenCanvas(across, down).getContext('2d', {willReadFrequently: true});
    if (!context) throw new Error('There is no canvas to decode pictures on.');
    context.imageSmoothingQuality = 'high';
    context.fillStyle = 'white';
    context.fillRect(0, 0, across, down);
    context.drawImage(bitmap, 0, 0, across, down);
    return context.getImageData(0, 0, across, down);
  } finally {
    bitmap.close();
  }
}

async function bitmapOf(picture: Blob): Promise<ImageBitmap> {
  try {
    return await createImageBitmap(picture, {
      imageOrientation: 'from-image',
      colorSpaceConversion: 'default',
    });
  } catch {
    throw new SolverError({
      code: 'not-an-image',
      message: 'The picture cannot be read; save it as JPEG or PNG.',
    });
  }
}

const flat = (points: readonly Point[]): Float64Array => Float64Array.from(points.flat());

const mapNumbers = ({homography, lens}: PhotoMap): Float64Array =>
  Float64Array.of(...homography, lens);

const bytesOf = ({data}: PhotoPixels): Uint8Array =>
  new Uint8Array(data.buffer, data.byteOffset, data.byteLength);

export const photoModuleRequest = (
  pixels: PhotoPixels,
  settings: PhotoSettings,
): ModulePhotoRequest => ({
  ...{width: pixels.width, height: pixels.height, pixels: bytesOf(pixels)},
  f35: settings.f35 ?? NaN,
  isTile: settings.isTile ?? false,
  anyEdges: settings.anyEdges ?? false,
  w1Cm: oneRepeat(settings.w1Measured) ?? NaN,
  w2Cm: oneRepeat(settings.w2Measured) ?? NaN,
  between: settings.between
    ? Float64Array.of(...settings.between.from, ...settings.between.to, settings.between.cm)
    : new Float64Array(),
  lattice: settings.lattice ? mapNumbers(settings.lattice) : new Float64Array(),
  keepsLattice: settings.keepsLattice ?? false,
  flatten: settings.flatten ?? 1,
});

export const photoTileModuleRequest = (
  pixels: PhotoPixels,
  {map, isTile = false, symmetrise, flatten = 1, shape}: PhotoTileSettings,
): ModulePhotoTileRequest => ({
  ...{width: pixels.width, height: pixels.height, pixels: bytesOf(pixels)},
  ...{map: mapNumbers(map), isTile, group: symmetrise ?? '', flatten, vectors: flat(shape)},
});

export const photoObjectModuleRequest = (
  pixels: PhotoPixels,
  {object, at, map, shape}: PhotoObjectSettings,
): ModuleObjectRequest => ({
  ...{width: pixels.width, height: pixels.height, pixels: bytesOf(pixels)},
  ...{map: mapNumbers(map), vectors: flat(shape), object, at: Float64Array.from(at)},
});

const mapOf = (numbers: Float64Array): PhotoMap => ({
  homography: Array.from(numbers.subarray(0, 9)) as unknown as Homography,
  lens: numbers[9] ?? 0,
});

const pointsOf = (numbers: Float64Array): readonly Point[] =>
  Array.from({length: numbers.length / 2}, (_, k) => [
    numbers[2 * k] ?? NaN,
    numbers[2 * k + 1] ?? NaN,
  ]);

const inParts = (numbers: Float64Array, length: number): readonly Float64Array[] =>
  Array.from({length: numbers.length / length}, (_, k) =>
    numbers.subarray(k * length, (k + 1) * length),
  );

const cornersOf = ([left = NaN, top = NaN, right = NaN, bottom = NaN]: Float64Array) =>
  [
    [left, top],
    [right, top],
    [right, bottom],
    [left, bottom],
  ] as const satisfies readonly Point[];

/** Error of a failure, with a message that begins like a sentence. */
const photoError = ({message, ...failure}: ModuleFailure): Error =>
  toError({...failure, message: message.charAt(0).toUpperCase() + message.slice(1)});

/** A name from the module, checked against the known names. */
function known<T extends string>(names: readonly T[], name: string): T {
  const found = names.find((one) => one === name);
  if (found === undefined) throw new Error(`The module names '${name}', which nobody knows.`);
  return found;
}

const groupOf = ({name, rho, worst, verdict, map}: ModulePhotoGroup): PhotoGroup => ({
  name: known(groupNames, name),
  ...{rho, worst, verdict: known(symmetryVerdicts, verdict), map: mapOf(map)},
});

/** Gaps on both sides of a border. The second side is shifted by half its length if `isAside`. */
function border(last: Side, first: Side, open: Float64Array, isAside = false): OpenEdge[] {
  const stretches = pointsOf(open);
  const moved = stretches.flatMap(([from, to]) =>
    [-0.5, 0.5]
      .map((by): Point => [Math.max(0, from + by), Math.min(1, to + by)])
      .filter(([a, b]) => a < b),
  );
  const edge =
    (side: Side) =>
    ([from, to]: Point): OpenEdge => ({side, from, to});
  return [...(isAside ? moved : stretches).map(edge(first)), ...stretches.map(edge(last))];
}

function seamsOf({across, up, halfDrop, brick}: ModuleTileSeams): TileSeams {
  const sides = border('right', 'left', across);
  const ends = border('bottom', 'top', up);
  return {
    straight: [...sides, ...ends],
    halfDrop: [...border('right', 'left', halfDrop, true), ...ends],
    brick: [...sides, ...border('bottom', 'top', brick, true)],
  };
}

/** Runs work on an image to its end. @throws {SolverError}; errors of `runInSlices` */
async function finish<Answer>(
  picture: ModulePictureWork<Answer>,
  hooks: PhotoHooks,
  pace: Pace,
): Promise<Answer> {
  const work = (milliseconds: number): boolean => {
    const more = stepsFor(milliseconds, () => picture.advance());
    const failure = picture.failure();
    if (failure) throw photoError(failure);
    hooks.onProgress?.({stage: known(photoStages, picture.stage()), fraction: picture.fraction()});
    return more;
  };
  await runInSlices(work, pace, hooks.signal);
  return picture.answer();
}

/** Reads a print. @throws {SolverError} if no print is found; errors of `runInSlices` */
export async function runPhoto(
  photo: ModulePictureWork<ModulePhotoReport>,
  {width, height}: PhotoPixels,
  hooks: PhotoHooks,
  pace: Pace,
  hasSeams = false,
): Promise<PhotoReading> {
  const {group, groups, vectors, isScaled, uncertainty, others, differing, seams, ...report} =
    await finish(photo, hooks, pace);
  const read = groups.map(groupOf);
  const own = read.find(({name}) => name === group);
  if (!own) throw new Error('A print has a group.');
  const [w1 = [1, 0], w2 = [0, 1]] = pointsOf(vectors);
  const unit = 1 / Math.hypot(...w1);
  const scaled = ([x, y]: Point): Point => [unit * x, unit * y];
  const {oneWay, stripes, copies, explained, seenAspect, seenError} = report;
  return {
    ...{width, height, map: own.map, ...vectorsAtMiddle(own.map, {width, height})},
    ...{w1: isScaled ? w1 : null, w2: isScaled ? w2 : null, shape: [scaled(w1), scaled(w2)]},
    seen: {aspect: seenAspect, error: seenError},
    ...{group: own.name, groups: read, latticeUncertainty: uncertainty},
    confidence: known(photoConfidences, report.confidence),
    ...{oneWay, stripes, copies, explained},
    notes: report.notes.map((note) => known(photoNotes, note)),
    others: inParts(others, 10).map(mapOf),
    differing: inParts(differing, 4).map(cornersOf),
    ...(hasSeams && {seams: seamsOf(seams)}),
  };
}

/** Makes a clean image of the print's cell. @throws {SolverError}; errors of `runInSlices` */
export async function runPhotoTile(
  tile: ModulePictureWork<ModuleTile>,
  gains: ColourGains | undefined,
  hooks: PhotoHooks,
  pace: Pace,
): Promise<PhotoPixels> {
  const {width, height, pixels} = await finish(tile, hooks, pace);
  if (gains) balance(pixels, gains);
  return {width, height, data: pixels};
}

/**
 * Finds an object of known size.
 * @throws {SolverError} if no such object is visible; errors of `runInSlices`
 */
export async function runPhotoObject(
  search: ModulePictureWork<ModuleObject>,
  {object, at}: PhotoObjectSettings,
  hooks: PhotoHooks,
  pace: Pace,
): Promise<PhotoObject> {
  const {outline, between, error} = await finish(search, hooks, pace);
  const [from = at, to = at] = pointsOf(between.subarray(0, 4));
  return {
    ...{object, outline: pointsOf(outline), error},
    between: {from, to, cm: between[4] ?? NaN},
  };
}

// White balance: factors of light for gamma-coded pixels.

/** Changes the pixels in place: red, green, blue, opacity. */
export function balance(pixels: Uint8Array | Uint8ClampedArray, gains: ColourGains): void {
  const tables = gains.map((gain) =>
    Uint8ClampedArray.from({length: 256}, (_, code) => 255 * codedOf(gain * linearOf(code / 255))),
  );
  tables.forEach((table, channel) => {
    for (let k = channel; k < pixels.length; k += 4) pixels[k] = table[pixels[k] ?? 0] ?? 0;
  });
}
