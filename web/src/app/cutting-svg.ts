/** The pieces of a solved design to cut along, as one file that stands alone. */
import {decidedOf, printOf} from '../model/design.js';
import {garmentTitle, panelMarks} from '../model/garment-marks.js';
import type {Workbench} from '../editor/index.js';

/** The picture of a cell as something a file may hold: SVG text, or a `data:` URL. */
async function embedded(image: string): Promise<string> {
  if (image.startsWith('data:')) return image;
  const response = await fetch(new URL(image, document.baseURI));
  if (!response.ok) throw new Error(`The print's image ${image} cannot be read; try again.`);
  const blob = await response.blob();
  return blob.type.startsWith('image/svg') ? blob.text() : dataUrl(blob);
}

const dataUrl = (blob: Blob): Promise<string> =>
  new Promise((resolve, reject) => {
    const reader = new FileReader();
    reader.onload = () => {
      resolve(reader.result as string); // what readAsDataURL gives
    };
    reader.onerror = () => {
      reject(new Error('The print’s image cannot be read; try again.'));
    };
    reader.readAsDataURL(blob);
  });

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
