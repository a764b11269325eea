/** The sample of a first visit, with its drape, which is stored. */
import {readStoredDrape} from '../../model/documents/stored-drape.js';
import {askingFor, type Design} from '../../model/design/design.js';
import {drapesOf} from '../../workbench/drape/drapes.js';
import type {Workbench} from '../../workbench/workbench.js';

/**
 * Begins with a design and shows its stored drape.
 * @param plain the design without symmetries
 * @throws {Error} if the file cannot be read
 */
export async function beginOpening(
  workbench: Workbench,
  plain: Promise<Design>,
  begin: (design: Design) => void,
): Promise<void> {
  const stored = fetch('opening.drape').then(async (response) => {
    if (!response.ok) throw new Error('opening.drape cannot be read; load the page again.');
    return readStoredDrape(await response.blob());
  });
  // fetched before the samples of the gallery, so that the first picture has its print
  const tile = plain.then(({print}) => workbench.tileOf(print.image).catch(() => undefined));
  const [design, {symmetries, drape, alignments}] = await Promise.all([plain, stored, tile]);
  begin({...design, symmetry: askingFor(symmetries)});
  drapesOf(workbench).know({drape, alignments});
}
