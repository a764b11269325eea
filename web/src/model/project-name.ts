/** What projects and the files made of them are called. */
import type {DesignGarment} from './design.js';
import {readable} from './piece-names.js';
import {text} from './read.js';

/** Longer ones fit no list and no file system. [characters] */
export const longestName = 80;

/** What somebody called a project. */
export const projectTitle = text(new RegExp(`^.{1,${longestName}}$`, 'su'), 'a name');

/** The name of a file without what programs put behind it. */
export const withoutEnding = (file: string): string =>
  file.replace(/(\.(seamwise|result))?\.json$/i, '') || file;

/** What a project is called until its owner calls it something else. */
export const nameOf = ({name, sample}: Pick<DesignGarment, 'name' | 'sample'>): string =>
  sample
    ? [readable(sample.style), sample.size.toUpperCase()].join(', ')
    : withoutEnding(name).slice(0, longestName);

/** A name as part of a file's: all that some system forbids there is left out. */
export const fileNameOf = (name: string): string =>
  name
    // eslint-disable-next-line no-control-regex
    .replace(/[\u0000-\u001f\u007f"*/:<>?\\|]+/g, ' ')
    .replace(/\s+/g, ' ')
    .replace(/^[. ]+|[. ]+$/g, '') || 'garment';
