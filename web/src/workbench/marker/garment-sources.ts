/** Garments that are added to a fabric, from samples and files. */
import {Malformed, fieldOf} from '../../model/base/read.js';
import type {AddedGarment, Design, DesignGarment} from '../../model/design/design.js';
import {readDesign} from '../../model/design/read-design.js';
import {isProject, readProject} from '../../model/documents/project.js';
import {bareFabric, newDesign} from '../samples.js';
import type {Workbench} from '../workbench.js';
import {addedFrom} from './garment-steps.js';

/** A garment that is not part of a project, with the symmetries that it has. */
export const fresh = (garment: DesignGarment): readonly AddedGarment[] =>
  addedFrom({...newDesign(garment, bareFabric), symmetry: 'auto'});

/** Limit of a file. [bytes] */
const most = 64 * 2 ** 20;

function contentOf(text: string): unknown {
  try {
    return JSON.parse(text);
  } catch {
    return undefined;
  }
}

/** The design of a result; undefined if the file has none. @throws {Malformed} if it is damaged */
function designIn(content: unknown): Design | undefined {
  const design = fieldOf(content, 'design');
  return design === undefined ? undefined : readDesign(design, 'design');
}

/**
 * The garments of a project, a result or a garment file; undefined for any other file.
 * @throws {FileError} for a damaged project
 * @throws {SolverError} for a garment that cannot be read
 */
export async function garmentsIn(
  file: Pick<File, 'name' | 'size' | 'text'>,
  {solving}: Pick<Workbench, 'solving'>,
): Promise<readonly AddedGarment[] | undefined> {
  if (file.size > most) return undefined;
  const text = await file.text();
  const content = contentOf(text);
  if (typeof content !== 'object' || content === null) return undefined;
  if (isProject(content)) return addedFrom(readProject(text, file.name).design);
  try {
    const design = designIn(content);
    if (design) return addedFrom(design);
  } catch (error) {
    if (error instanceof Malformed) return undefined;
    throw error;
  }
  if (fieldOf(content, 'w1') !== undefined) return undefined; // a print
  const garment = {name: file.name, text};
  await solving.documentOf(garment);
  return fresh(garment);
}
