/** Opens a file as the print of a workbench's design. */
import {noPicture} from '../../model/design/design.js';
import {textsOf} from '../../texts/texts.js';
import {openEdgesOf, openPairs} from '../../print/own-groups.js';
import {printOfPicture} from '../../print/own-print.js';
import {OpenEdgesError} from '../../print/openable-files.js';
import {looksLikePicture} from '../../print/read-picture.js';
import {readOwnPicture, readPrint} from '../../print/read-print.js';
import {takePrint} from './take-print.js';
import type {Workbench} from '../workbench.js';

/**
 * Reads a print and shows the design on it. An image completes a print that lacks its image. The
 * user has to decide about an image that is not seamless.
 * @throws {Error} with one sentence about the problem; the print stays unchanged
 */
export async function openPrint(workbench: Workbench, file: File): Promise<void> {
  const {language, messages} = workbench.preferences.chosen;
  const words = textsOf(language, messages).print.files;
  const present = workbench.history.design?.print;
  workbench.notices.doubtful = undefined;
  if (!(await looksLikePicture(file))) {
    takePrint(workbench, await readPrint(workbench.solver, file, words));
    return;
  }
  const own = await readOwnPicture(file, words);
  if (present?.image === noPicture && !present.sample) {
    workbench.history.change({print: {...present, image: own.image}});
    return;
  }
  const edges = await openEdgesOf(workbench.solver, own);
  if (edges.length > 0) {
    if (present) workbench.notices.doubtful = {own, edges, beside: present};
    throw new OpenEdgesError(words.openEdges[openPairs(edges)](file.name));
  }
  takePrint(workbench, await printOfPicture(workbench.solver, own));
}
