/**
 * Table of all requests to the solver and their answers: the only place that names modules and
 * kinds of requests.
 */
import type {GarmentDocument} from '../model/garment/garment-document.js';
import type {DetectedSymmetries, MeasuredSymmetry} from '../model/garment/symmetries.js';
import {Answerer, type AnswererOptions, type AnswerTable, type Queue} from './answers/answerer.js';
import {owning, runInSlices, stepsFor} from './answers/slices.js';
import {drapeRequest, runDrape} from './answers/drape.js';
import {documentBytes, toError, valueOf} from './json/document.js';
import {garmentText} from './json/garment-text.js';
import {markerRequest, runMarker} from './answers/marker.js';
import type {DrapeModule} from './module/drape.mjs';
import {drape, marker, photo, seamwise} from './module/load.js';
import type {MarkerModule} from './module/marker.mjs';
import type {PhotoModule} from './module/photo.mjs';
import type {SeamwiseModule} from './module/seamwise.mjs';
import {
  decoded,
  photoModuleRequest,
  photoObjectModuleRequest,
  photoTileModuleRequest,
  runPhoto,
  runPhotoObject,
  runPhotoTile,
} from './answers/photo.js';
import {requestChecks} from './requests/request-checks.js';
import {plainNames, type Requests} from './requests/requests.js';
import type {Helpers} from './threads/helpers.js';
import {run, runProof, runToPattern, Solver} from './answers/solve.js';

export {besideThePage} from './answers/slices.js';

/** The WebAssembly modules; each is loaded at the first request that needs it. */
type SolverModules = {
  readonly seamwise: SeamwiseModule;
  readonly drape: DrapeModule;
  readonly marker: MarkerModule;
  readonly photo: PhotoModule;
};

/**
 * Two at once, so that a small solve need not wait for a large one. More at once would only delay
 * all.
 */
const solves: Queue = {atOnce: 2};

/** One at once, because a share is useful as soon as it is complete. */
const shares: Queue = {atOnce: 1};

/** One at once, because only the drape on display is needed. More at once would only delay all. */
const drapes: Queue = {atOnce: 1};

/** One layout at a time. */
const markers: Queue = {atOnce: 1};

/** One at once, because an image takes a large part of the available memory. */
const photos: Queue = {atOnce: 1};

/** Short slices, because a share that is no longer needed must not delay others. [ms] */
const shareSlice = 20;

/** Builds the table. @param helpers other threads for long searches; none by default */
export const answerTable = (helpers?: Helpers): AnswerTable<Requests, SolverModules> => ({
  modules: {seamwise, drape, marker, photo},
  checks: requestChecks,
  laterChecks: async () => (await import('./requests/later-checks.js')).laterChecks,
  requests: {
    solve: {
      module: 'seamwise',
      queue: solves,
      transfers: ['onPartial'],
      answer: (module, texts, {hooks, pace, compiled}) =>
        owning(new Solver(module, texts), async (solver) => {
          const help = () => helpers?.help(solver, compiled, hooks.helpers ?? 0) ?? false;
          try {
            return await run(solver, hooks, pace, help);
          } finally {
            helpers?.leave(solver);
          }
        }),
    },
    prepare: {
      module: 'seamwise',
      answer: (module, texts, {hooks, pace}) =>
        owning(new Solver(module, texts), (solver) => runToPattern(solver, hooks, pace)),
    },
    prove: {
      module: 'seamwise',
      answer: (module, texts, {hooks, pace, isIdle}) =>
        owning(new Solver(module, texts), (solver) =>
          runProof(solver, hooks, pace, () => isIdle(solves)),
        ),
    },
    mirror: {
      module: 'seamwise',
      answer: (module, {garment, name, symmetries}) => {
        const files = [documentBytes(garment, module), documentBytes(symmetries, module)] as const;
        const measured = module.measureSymmetries(files[0], name, files[1], plainNames.symmetry);
        return (valueOf(measured) as {symmetries: [MeasuredSymmetry]}).symmetries[0];
      },
    },
    symmetries: {
      module: 'seamwise',
      answer: (module, {garment, name}, {hooks, pace}) =>
        owning(new module.Detection(documentBytes(garment, module), name), async (detection) => {
          const step = () => detection.advance(1);
          await runInSlices((slice) => stepsFor(slice, step), pace, hooks.signal);
          return valueOf(detection.result()) as DetectedSymmetries;
        }),
    },
    garment: {
      module: 'seamwise',
      answer: (module, {garment, name}) =>
        valueOf(module.garment(documentBytes(garment, module), name)) as GarmentDocument,
    },
    convert: {
      module: 'seamwise',
      answer: (module, {garment, name}) => {
        valueOf(module.garment(documentBytes(garment, module), name)); // rejects an invalid garment
        return garmentText(garment);
      },
    },
    drape: {
      module: 'drape',
      queue: drapes,
      transfers: ['onPositions'],
      answer: (module, texts, {hooks, pace}) =>
        owning(new module.Drape(drapeRequest(module, texts)), (cloth) =>
          runDrape(cloth, hooks, pace),
        ),
    },
    marker: {
      module: 'marker',
      queue: markers,
      answer: (module, problem, {hooks, pace}) =>
        owning(new module.Marker(markerRequest(problem)), (layout) =>
          runMarker(layout, hooks, pace),
        ),
    },
    photo: {
      module: 'photo',
      queue: photos,
      answer: async (module, {picture, ...settings}, {hooks, pace}) => {
        const pixels = await decoded(picture);
        hooks.signal?.throwIfAborted();
        return owning(module.photo(photoModuleRequest(pixels, settings)), (reading) =>
          runPhoto(reading, pixels, hooks, pace, settings.anyEdges),
        );
      },
    },
    photoTile: {
      module: 'photo',
      queue: photos,
      transfers: ['answer'],
      answer: async (module, {picture, ...settings}, {hooks, pace}) => {
        const pixels = await decoded(picture);
        hooks.signal?.throwIfAborted();
        return owning(module.photoTile(photoTileModuleRequest(pixels, settings)), (tile) =>
          runPhotoTile(tile, settings.gains, hooks, pace),
        );
      },
    },
    photoObject: {
      module: 'photo',
      queue: photos,
      answer: async (module, {picture, ...settings}, {hooks, pace}) => {
        const pixels = await decoded(picture);
        hooks.signal?.throwIfAborted();
        return owning(module.photoObject(photoObjectModuleRequest(pixels, settings)), (search) =>
          runPhotoObject(search, settings, hooks, pace),
        );
      },
    },
    share: {
      module: 'seamwise',
      queue: shares,
      transfers: ['answer'],
      answer: (module, {order}, {hooks, pace}) =>
        owning(new module.Share(order), async (share) => {
          const work = (slice: number) => {
            const more = stepsFor(slice, () => share.advance(1));
            const failure = share.failure();
            if (failure) throw toError(failure);
            return more;
          };
          await runInSlices(work, {...pace, slice: shareSlice}, hooks.signal);
          return share.answers();
        }),
    },
    memory: {
      module: 'seamwise',
      answer: (module) => ({heap: module.heapBytes(), live: module.liveBytes()}),
    },
  },
});

/** Answers requests on the calling thread. */
export type LocalAnswerer = Answerer<Requests, SolverModules>;

/** Creates a local answerer. @param helpers other threads for long searches; none by default */
export const localAnswerer = (
  options?: AnswererOptions<SolverModules>,
  helpers?: Helpers,
): LocalAnswerer => new Answerer(answerTable(helpers), options);
