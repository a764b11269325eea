/** Records a film of one turn around a drape, in real time. */
import type {DrapeView} from '../../viewer/drape/drape-view.js';

/** Duration of one turn. [ms] */
const turnTime = 8000;
/** [px] */
const widest = 1280;
/** [bits per second] */
const rate = 8e6;

/** Formats of a film; a browser supports one or the other. */
const types = ['video/webm;codecs=vp9', 'video/webm', 'video/mp4'];

/** Returns the format that this browser can record; undefined for none. */
export const filmType = (): string | undefined =>
  'MediaRecorder' in globalThis && 'captureStream' in HTMLCanvasElement.prototype
    ? types.find((type) => MediaRecorder.isTypeSupported(type))
    : undefined;

/** @throws {Error} if drawing or recording is impossible, or while the graphics context is lost */
export async function film(view: DrapeView, type: string): Promise<Blob> {
  const width = 2 * Math.floor(Math.min(widest, view.widestPicture) / 2);
  const canvas = document.createElement('canvas');
  const context = canvas.getContext('2d');
  const show = async (share: number): Promise<void> => {
    const picture = await view.onTheWayRound(width, share);
    const height = 2 * Math.floor(picture.height / 2); // codecs require even sides
    if (canvas.height !== height) Object.assign(canvas, {width, height});
    context?.drawImage(picture, 0, 0);
  };
  await show(0); // the first frame must have content
  const recorder = new MediaRecorder(canvas.captureStream(), {
    ...{mimeType: type, videoBitsPerSecond: rate},
  });
  const parts: Blob[] = [];
  const ended = new Promise((resolve, reject) => {
    recorder.addEventListener('stop', resolve);
    recorder.addEventListener('error', reject);
    recorder.addEventListener('dataavailable', ({data}) => parts.push(data));
  });
  recorder.start();
  try {
    const begun = performance.now();
    for (let share = 0; share < 1; share = (performance.now() - begun) / turnTime) {
      await show(share);
      await new Promise((resolve) => setTimeout(resolve)); // lets other tasks run
    }
  } finally {
    recorder.stop();
  }
  await ended;
  return new Blob(parts, {type: recorder.mimeType});
}
