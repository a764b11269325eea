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

const drawingEnding =
  /(\.(aama|astm|browzwear|clo|flat|gerber|lectra|optitex|polypattern|richpeace|valentina))?\.(dxf|obj|svg)$/i;

/** The name of a drawing's file without what programs put behind it: "tee-m" of "tee-m.gerber.dxf". */
export const drawingName = (file: string): string =>
  file.replace(/^.*[/\\]/, '').replace(drawingEnding, '') || file;

/** Programs cut names off at so many. [characters] */
const shortestCut = 20;

/** What a drawing calls itself, which may be a file's name, or the beginning of its own. */
export function drawingTitle(stated: string, file: string): string {
  const [title, own] = [drawingName(stated.trim()), drawingName(file)];
  return title.length >= shortestCut && own.startsWith(title) ? own : title;
}

/** A longer name ends in an ellipsis. */
export function shortened(name: string, most: number = longestName): string {
  const letters = Array.from(name);
  return letters.length > most ? `${letters.slice(0, most - 1).join('')}…` : name;
}

/** What a project is called until its owner calls it something else. */
export const nameOf = ({name, sample}: Pick<DesignGarment, 'name' | 'sample'>): string =>
  sample
    ? [readable(sample.style), sample.size.toUpperCase()].join(', ')
    : shortened(withoutEnding(name));

/** A name as part of a file's: all that some system forbids there is left out. */
export const fileNameOf = (name: string): string =>
  name
    // eslint-disable-next-line no-control-regex
    .replace(/[\u0000-\u001f\u007f"*/:<>?\\|]+/g, ' ')
    .replace(/\s+/g, ' ')
    .replace(/^[. ]+|[. ]+$/g, '') || 'garment';
