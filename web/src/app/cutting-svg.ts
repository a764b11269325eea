/** The pieces of a solved design to cut along, as one file that stands alone. */
import {decidedOf, printOf} from '../model/design.js';
import {garmentTitle, panelMarks} from '../model/garment-marks.js';
import {dataUrlOf} from '../recognition/data-url.js';
import {fetchPicture} from '../recognition/tile.js';
import type {Workbench} from '../editor/index.js';

/** The picture of a cell as something a file may hold: SVG text, or a `data:` URL. */
async function embedded(image: string): Promise<string> {
  if (image.startsWith('data:')) return image;
  const blob = await fetchPicture(new URL(image, document.baseURI));
  return blob.type.startsWith('image/svg') ? blob.text() : dataUrlOf(blob);
}

/** @throws {Error} when the print's image cannot be read; undefined before there is a result */
export async function cuttingSvg(
  {design, garment, result, preferences}: Workbench,
  allowanceCm: number,
): Promise<string | undefined> {
  if (!design || !garment || !result) return undefined;
  const [{cuttingFile}, tile] = await Promise.all([
    import('../cutting/cutting-file.js'), // offsetting is a matter of this file alone
    embedded(design.print.image),
  ]);
  const {units, language} = preferences;
  return cuttingFile(
    result,
    {...printOf(design.print), tile},
    {
      ...garmentTitle(garment, design.garment.name),
      panels: panelMarks(garment, decidedOf(design)),
    },
    {allowanceCm, units, locale: language, plain: design.options.plain ?? []},
  );
}
