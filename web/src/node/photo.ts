/** Prints read off pictures of their cloth. */
import type {
  PhotoHooks,
  PhotoPixels,
  PhotoReading,
  PhotoRequest,
  PhotoSettings,
  PhotoTileRequest,
} from '../model/photo.js';
import type {Print} from '../model/print.js';
import {isSymmetric, printOfPhoto} from '../recognition/photo-print.js';

export interface PrintFromPixelsSettings extends PhotoSettings {
  /** Makes the symmetries of the group that was found exact; as the cloth has them, if left out. */
  readonly symmetrise?: boolean;
}

export interface PrintFromPixels {
  readonly reading: PhotoReading;
  /** Its lengths are in proportion only, and `unscaled` says so, until one of them is known. */
  readonly print: Print;
  /** The print's cell, w1 to the right and w2 up. */
  readonly tile: PhotoPixels;
}

/** What the solver is asked. */
interface Reads {
  readonly photo: (request: PhotoRequest, hooks: PhotoHooks) => Promise<PhotoReading>;
  readonly photoTile: (request: PhotoTileRequest, hooks: PhotoHooks) => Promise<PhotoPixels>;
}

/** Reading takes about half of the time, and the tile the other half. */
const share = 0.5;

/** @throws as `printFromPixels` does */
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
