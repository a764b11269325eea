/** Files of a drape. */
import {printOf} from '../../model/design/design.js';
import {cellPicture, glb, type CellPicture} from '../../files/glb/glb.js';
import {norm} from '../../model/geometry/vectors.js';
import {titleOfFile} from '../../model/garment/piece-names.js';
import {imageCell} from '../../model/print/wallpaper.js';
import {drapeTexts} from '../../texts/drape-texts.js';
import {pngOf} from '../../viewer/read-back.js';
import {onWhite} from '../../viewer/tile-texture.js';
import {drapesOf} from '../../workbench/drape/drapes.js';
import type {Workbench} from '../../workbench/workbench.js';
import type {DrapePane} from '../../editor/drape/drape-pane.js';
import type {DrapeView} from '../../viewer/drape/drape-view.js';
import {toFailure} from '../../workbench/latest-solve.js';
import type {MarkerPane} from '../../editor/marker/marker-pane.js';
import type {Command} from '../../commands/editor-command.js';

interface DrapeFileChoice {
  readonly id: string;
  readonly title: string;
  /** Suffix of the file name. */
  readonly ending: string;
  /** @throws {Error} one sentence as its message */
  readonly make: () => Promise<Blob>;
}

/** Longest side of a cell's image; viewers on phones accept no larger one. [px] */
const greatestSide = 2048;

/** Returns the files that can be saved at present. */
function drapeFiles({workbench, view}: DrapePane): readonly DrapeFileChoice[] {
  const {language, messages} = workbench.preferences.chosen;
  const words = drapeTexts(language, messages);
  const {drape} = drapesOf(workbench);
  if (!view || !drape) return [];
  const type = filmType();
  return [
    {id: 'picture', title: words.savePicture, ending: 'worn.png', make: () => view.shot()},
    {id: 'model', title: words.saveModel, ending: 'glb', make: () => model(workbench)},
    ...(type === undefined
      ? []
      : [
          {
            ...{id: 'film', title: words.saveFilm, ending: type.includes('mp4') ? 'mp4' : 'webm'},
            make: async () => {
              workbench.notices.say({tone: 'info', text: words.filming});
              const blob = await film(view, type);
              workbench.notices.say(undefined);
              return blob;
            },
          },
        ]),
  ];
}

async function model(workbench: Workbench): Promise<Blob> {
  const {design} = workbench.history;
  const {result} = workbench.solving;
  const {drape} = drapesOf(workbench);
  if (!design || !result || !drape) throw new Error('There is no garment to save yet.');
  const picture = await cellOf(workbench);
  const bytes = glb(result, drape, printOf(design.print), {
    ...(picture && {picture}),
    ...(design.options.plain && {plain: design.options.plain}),
    garment: titleOfFile(design.garment.name),
  });
  return new Blob([Uint8Array.from(bytes)], {type: 'model/gltf-binary'});
}

/**
 * Returns the image of the print's cell on white fabric, as a PNG; undefined if it cannot be read.
 */
async function cellOf({history: {design}, tileOf}: Workbench): Promise<CellPicture | undefined> {
  if (!design) return undefined;
  const tile = await tileOf(design.print.image).catch(() => undefined);
  if (!tile) return undefined;
  const isVector = 'vector' in tile;
  const [across, up] = imageCell(printOf(design.print));
  const [width, height] = isVector ? [norm(across), norm(up)] : [tile.width, tile.height];
  const longest = Math.max(width, height);
  const scale = (isVector ? greatestSide : Math.min(greatestSide, longest)) / longest;
  const canvas = onWhite(isVector ? tile.vector : tile, scale * width, scale * height);
  const blob = canvas && (await pngOf(canvas).catch(() => undefined));
  return blob && cellPicture(new Uint8Array(await blob.arrayBuffer()));
}

// Records a film of one turn around a drape, in real time.

/** Duration of one turn. [ms] */
const turnTime = 8000;
/** [px] */
const widest = 1280;
/** [bits per second] */
const rate = 8e6;

/** Formats of a film; a browser supports one or the other. */
const types = ['video/webm;codecs=vp9', 'video/webm', 'video/mp4'];

/** Returns the format that this browser can record; undefined for none. */
const filmType = (): string | undefined =>
  'MediaRecorder' in globalThis && 'captureStream' in HTMLCanvasElement.prototype
    ? types.find((type) => MediaRecorder.isTypeSupported(type))
    : undefined;

/** @throws {Error} if drawing or recording is impossible, or while the graphics context is lost */
async function film(view: DrapeView, type: string): Promise<Blob> {
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

// Commands that save files of the view beside the pattern; loaded with the list that shows them.

/** @param save receives the content and the ending of the file's name */
export const viewSaves = (
  view: DrapePane | MarkerPane,
  workbench: Workbench,
  save: (ending: string, content: Blob) => void,
): readonly Command[] =>
  ('files' in view ? view.files : drapeFiles(view)).map(({id, title, ending, make}) => ({
    ...{id: `save view ${id}`, title},
    run: () => {
      make().then(
        (content) => {
          save(ending, content);
        },
        (error: unknown) => {
          workbench.notices.say({tone: 'error', text: toFailure(error).message});
        },
      );
    },
  }));
