/** Searches layouts of pieces on fabric, in slices. */
import type {Alignment, Point} from '../../model/geometry/vectors.js';
import type {
  MarkerAnswer,
  MarkerHooks,
  MarkerLayout,
  MarkerPiece,
  MarkerProblem,
} from '../../model/result/marker-search.js';
import {runInSlices, stepsFor, type Pace} from './slices.js';
import type {
  ModuleLayout,
  ModuleMarker,
  ModuleMarkerPiece,
  ModuleMarkerRequest,
} from '../module/marker.mjs';
import {toError} from '../json/document.js';

/** Work of one call, small enough to end within a few milliseconds. [million table reads] */
const workAtOnce = 2;

const flat = (points: readonly Point[]): Float64Array => Float64Array.from(points.flat());

const placeNumbers = ({angle, translation: [x, y]}: Alignment): Float64Array =>
  Float64Array.of(angle, x, y);

const modulePiece = (piece: MarkerPiece): ModuleMarkerPiece => ({
  ...{name: piece.name, garment: piece.garment, turns: piece.turns},
  outline: flat(piece.outline),
  angle: piece.alignment.angle,
  x: piece.alignment.translation[0],
  y: piece.alignment.translation[1],
  upX: piece.up[0],
  upY: piece.up[1],
  shifts: flat(piece.shifts),
  pin: piece.pin ? placeNumbers(piece.pin) : new Float64Array(),
});

export const markerRequest = ({
  print: {group, w1, w2},
  ...problem
}: MarkerProblem): ModuleMarkerRequest => ({
  ...{group, w1x: w1[0], w1y: w1[1], w2x: w2[0], w2y: w2[1]},
  pieces: problem.pieces.map(modulePiece),
  ...{width: problem.widthCm, selvedge: problem.selvedgeCm, gap: problem.gapCm},
  ...{repeatTolerance: problem.repeatTolerance, nap: problem.nap},
  ...{wholeRepeats: problem.wholeRepeats, ignoresPrint: problem.ignoresPrint},
  phases: Float64Array.from(problem.phasesCm),
  start: problem.startCm ?? NaN,
  flaws: problem.flaws.map(flat),
  widths: Float64Array.from(problem.widthsCm),
  ...{alsoFree: problem.alsoFree, effort: problem.effort, seed: problem.seed},
});

const layoutOf = ({length, originX, originY, places}: ModuleLayout): MarkerLayout => ({
  lengthCm: length,
  printOrigin: [originX, originY],
  places: Array.from({length: places.length / 3}, (_, k) => {
    const [angle = NaN, x = NaN, y = NaN] = places.subarray(3 * k, 3 * k + 3);
    return Number.isNaN(angle) ? null : {angle, translation: [x, y]};
  }),
});

const lengthsOf = (lengths: Float64Array): readonly (number | null)[] =>
  Array.from(lengths, (length) => (Number.isNaN(length) ? null : length));

/**
 * Runs a search to its end.
 * @throws {SolverError} if the pieces do not fit on the fabric; errors of `runInSlices`
 */
export async function runMarker(
  marker: ModuleMarker,
  hooks: MarkerHooks,
  pace: Pace,
): Promise<MarkerAnswer> {
  let told = 0;
  const advance = (): boolean => {
    const more = marker.advance(workAtOnce);
    const failure = marker.failure();
    if (failure) throw toError(failure);
    return more;
  };
  const work = (milliseconds: number): boolean => {
    const more = stepsFor(milliseconds, advance);
    hooks.onProgress?.({stage: marker.stage(), fraction: marker.fraction()});
    if (hooks.onLayout && marker.count() > told) {
      told = marker.count();
      hooks.onLayout(layoutOf(marker.layout()));
    }
    return more;
  };
  await runInSlices(work, pace, hooks.signal);
  const {bound, proven, freeLength, phaseLengths, widthLengths} = marker.report();
  return {
    ...layoutOf(marker.layout()),
    ...{boundCm: bound, proven, freeLengthCm: freeLength === 0 ? null : freeLength},
    phaseLengthsCm: lengthsOf(phaseLengths),
    widthLengthsCm: lengthsOf(widthLengths),
  };
}
