/** Names of projects and of the files made from them. */
import type {DesignGarment} from '../design/design.js';
import {readable} from '../garment/piece-names.js';
import {text} from '../base/read.js';

/** Greatest length of a name; longer ones suit neither lists nor file systems. [characters] */
export const longestName = 80;

/** Reads a project's name. */
export const projectTitle = text(new RegExp(`^.{1,${longestName}}$`, 'su'), 'a name');

/** Name of a file without the endings that programs add. */
export const withoutEnding = (file: string): string =>
  file.replace(/(\.(seamwise|result))?\.json$/i, '') || file;

/** Shortens a name; a longer one ends in an ellipsis. */
export function shortened(name: string, most: number = longestName): string {
  const letters = Array.from(name);
  return letters.length > most ? `${letters.slice(0, most - 1).join('')}…` : name;
}

/**
 * Name of a project before its owner chooses one.
 * @param style of a sample, in the user's language
 */
export const nameOf = (
  {name, sample}: Pick<DesignGarment, 'name' | 'sample'>,
  style?: string,
): string =>
  sample
    ? [style ?? readable(sample.style), sample.size.toUpperCase()].join(', ')
    : shortened(withoutEnding(name));

/** A name as part of a file name, without the characters that some system forbids. */
export const fileNameOf = (name: string): string =>
  name
    // eslint-disable-next-line no-control-regex
    .replace(/[\u0000-\u001f\u007f"*/:<>?\\|]+/g, ' ')
    .replace(/\s+/g, ' ')
    .replace(/^[. ]+|[. ]+$/g, '') || 'garment';
