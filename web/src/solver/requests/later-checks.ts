/** Checks requests for a drape, a layout or a photo; they load with the first of them. */
import {bytes, either, fields, having, optional, type Checks} from '../../model/base/arguments.js';
import {groupNames} from '../../model/base/core-tables.js';
import {fail, flag, listOf, number, oneOf, pairOf, type Read} from '../../model/base/read.js';
import type {Alignment} from '../../model/geometry/vectors.js';
import {
  knownObjects,
  type PhotoMap,
  type PhotoObjectRequest,
  type PhotoPixels,
  type PhotoRequest,
  type PhotoTileRequest,
} from '../../model/print/photo-reading.js';
import {naps, type MarkerPiece, type MarkerProblem} from '../../model/result/marker-search.js';
import type {DrapeInputs} from './requests.js';
import {numbers, seed, word, type LaterKind, type RequestChecks} from './request-checks.js';

const finite = number(-1e9, 1e9);
const point = pairOf(finite);
const points = listOf(point);
const drape = having<DrapeInputs>({
  ...{result: word, resultName: word, body: word, bodyName: word, fabric: word, size: word},
  ...{effort: number(1, 4), settled: numbers},
});

const alignment = having<Alignment>({angle: finite, translation: point});

const piece = having<MarkerPiece>({
  ...{name: word, garment: number(0, 1e6), outline: points, alignment, up: point, shifts: points},
  ...{turns: oneOf(['half', 'quarter', 'any']), pin: optional(alignment)},
});

const marker = having<MarkerProblem>({
  print: having({group: oneOf(groupNames), w1: point, w2: point}),
  ...{pieces: listOf(piece), widthCm: finite, selvedgeCm: finite, gapCm: finite},
  ...{repeatTolerance: finite, nap: oneOf(naps), wholeRepeats: flag, ignoresPrint: flag},
  ...{phasesCm: listOf(finite), startCm: optional(finite), flaws: listOf(points)},
  ...{widthsCm: listOf(finite), alsoFree: flag, effort: number(0, 1000), seed},
});

const clamped: Read<unknown> = (value, at) =>
  value instanceof Uint8ClampedArray ? value : fail(at, 'a Uint8ClampedArray');

const side = number(1, 1e6);

/** Accepts the pixels of an image, four bytes each. */
export const pixels: Read<PhotoPixels> = (value, at) => {
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

const picture: Read<unknown> = (value, at) => (value instanceof Blob ? value : pixels(value, at));

/** Accepts the nine numbers of a homography: of pixels, so that images limit them. */
const homography: Read<readonly number[]> = (value, at) => {
  const entries = listOf(number(-1e6, 1e6))(value, at);
  return entries.length === 9 ? entries : fail(at, 'a list of nine numbers');
};
const map = fields<PhotoMap>({homography, lens: finite}, 'homography', 'lens');
const shape = pairOf(point);

const measured = fields({repeats: finite, cm: finite}, 'repeats', 'cm');

/** Facts about a photo, apart from its pixels. */
export const photoFacts: Checks<Omit<PhotoRequest, 'picture'>> = {
  ...{f35: number(1, 10_000), isTile: flag, anyEdges: flag, keepsLattice: flag},
  ...{w1Measured: measured, w2Measured: measured, flatten: number(0, 1), lattice: map},
  between: fields({from: point, to: point, cm: finite}, 'from', 'to', 'cm'),
};

const gains: Read<unknown> = (value, at) => {
  const three = listOf(number(0, 1e3))(value, at);
  return three.length === 3 ? three : fail(at, 'a list of three numbers');
};

/** The check of each kind of request to the modules for drapes, layouts and photos. */
export const laterChecks: RequestChecks<LaterKind> = {
  ...{drape, marker},
  photo: fields<PhotoRequest>({...photoFacts, picture}, 'picture'),
  photoTile: fields<PhotoTileRequest>(
    {
      ...{picture, map, shape, gains, isTile: flag, flatten: number(0, 1)},
      symmetrise: oneOf(groupNames),
    },
    ...(['picture', 'map', 'shape'] as const),
  ),
  photoObject: fields<PhotoObjectRequest>(
    {picture, map, shape, object: oneOf(knownObjects), at: point},
    ...(['picture', 'map', 'shape', 'object', 'at'] as const),
  ),
};
