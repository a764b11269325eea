/** Reads prints from photos of their fabric. */
import {isSymmetric, printOfPhoto} from '../image/photo-print.js';
import type {
  PhotoHooks,
  PhotoPixels,
  PhotoReading,
  PhotoRequest,
  PhotoSettings,
  PhotoTileRequest,
} from '../model/print/photo-reading.js';
import type {Print} from '../model/print/repeating-print.js';

export interface PrintFromPixelsSettings extends PhotoSettings {
  /** Makes the symmetries of the detected group exact. Default false. */
  readonly symmetrise?: boolean;
}

export interface PrintFromPixels {
  readonly reading: PhotoReading;
  /**
   * The print. Its lengths are only proportional, as `unscaled` states, until one of them is known.
   */
  readonly print: Print;
  /** The print's cell, with w1 to the right and w2 up. */
  readonly tile: PhotoPixels;
}

/** Solver functions that read a photo. */
interface Reads {
  readonly photo: (request: PhotoRequest, hooks: PhotoHooks) => Promise<PhotoReading>;
  readonly photoTile: (request: PhotoTileRequest, hooks: PhotoHooks) => Promise<PhotoPixels>;
}

/** Share of the time for reading; the tile takes the rest. */
const share = 0.5;

/**
 * Reads a print from pixels.
 * @throws {SolverError} under the conditions of `printFromPixels`
 */
export async function printWith(
  {photo, photoTile}: Reads,
  pixels: PhotoPixels,
  {symmetrise = false, ...settings}: PrintFromPixelsSettings,
  {signal, onProgress}: PhotoHooks,
): Promise<PrintFromPixels> {
  const hooks = (from: number): PhotoHooks => ({
    ...(signal && {signal}),
    ...(onProgress && {
      onProgress: ({stage, fraction}) => {
        onProgress({stage, fraction: from + share * fraction});
      },
    }),
  });
  const reading = await photo({...settings, picture: pixels}, hooks(0));
  const tile = await photoTile(
    {
      ...{picture: pixels, map: reading.map, shape: reading.shape},
      ...(settings.isTile && {isTile: true}),
      ...(settings.flatten !== undefined && {flatten: settings.flatten}),
      ...(symmetrise && isSymmetric(reading) && {symmetrise: reading.group}),
    },
    hooks(share),
  );
  return {reading, print: printOfPhoto(reading), tile};
}
