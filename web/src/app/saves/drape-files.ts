/** Files of a drape. */
import {printOf} from '../../model/design/design.js';
import {cellPicture, glb, type CellPicture} from '../../model/documents/glb.js';
import {norm} from '../../model/geometry/vectors.js';
import {titleOfFile} from '../../model/garment/piece-names.js';
import {imageCell} from '../../model/print/wallpaper.js';
import {wornTexts} from '../../texts/drape-texts.js';
import {pngOf} from '../../viewer/read-back.js';
import {onWhite} from '../../viewer/tile-texture.js';
import {film, filmType} from './film.js';
import {drapingOf} from '../../workbench/drape/draping.js';
import type {Workbench} from '../../workbench/workbench.js';
import type {DrapePane} from '../../editor/drape/drape-pane.js';

interface WornFile {
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
export function drapeFiles({workbench, view}: DrapePane): readonly WornFile[] {
  const {language, messages} = workbench.preferences.chosen;
  const words = wornTexts(language, messages);
  const {drape} = drapingOf(workbench);
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
  const {drape} = drapingOf(workbench);
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
