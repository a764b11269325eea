/** A project as the fragment of an address, to be passed on: all of it but what samples hold themselves. */
import {bytesOf, deflated, Inflated, inflated} from './deflated.js';
import {decisionsOf, type Design, type DesignGarment, type DesignPrint} from './design.js';
import {
  decisions,
  garmentSample,
  ownGarment,
  ownPicture,
  ownTile,
  printMeasures,
  printSample,
} from './design-reader.js';
import {projectTitle} from './project-name.js';
import {fieldOf, Malformed, shape, text, type Read} from './read.js';
import type {PrintTile} from './print-tile.js';
import {written} from './written-design.js';

/** A garment in a link: a sample's name, or the whole garment. */
export type LinkedGarment =
  {readonly sample: NonNullable<DesignGarment['sample']>} | Pick<DesignGarment, 'name' | 'text'>;

/** Of a picture that was made of one that somebody opened, only that one is carried. */
export type LinkedPrint = Pick<
  DesignPrint,
  'group' | 'size' | 'turnDeg' | 'oneWay' | 'cell' | 'unscaled'
> &
  (
    | {readonly sample: NonNullable<DesignPrint['sample']>}
    | Pick<DesignPrint, 'title' | 'image'>
    | (Pick<DesignPrint, 'title'> & {readonly tile: PrintTile})
  );

export interface LinkedProject extends Design<LinkedGarment, LinkedPrint> {
  /** What its sender calls it. */
  readonly title?: string;
}

/** A fragment that was meant to be a project, and is none. */
export class LinkError extends Error {
  override readonly name = 'LinkError';
}

const start = '#project=';
/** Of links as they were made before they were deflated. */
const plainStart = '#design=';
/** Browsers and servers take no endless addresses. [characters] */
export const longestLink = 200_000;
/** Of a project that a link unfolds to. [bytes] */
const largest = 8 * 2 ** 20;

/** By whether it has a field. */
const either =
  <A, B>(field: string, having: Read<A>, other: Read<B>): Read<A | B> =>
  (value, at) =>
    fieldOf(value, field) === undefined ? other(value, at) : having(value, at);

const title = text(/^.{0,255}$/su, 'a title');
const garment = either('sample', shape({sample: garmentSample}), ownGarment);
const print = either(
  'sample',
  shape({sample: printSample}),
  either('tile', shape({title, tile: ownTile}), shape({title, image: ownPicture})),
);

const linked: Read<LinkedProject> = (value, at) => {
  const found = shape(
    {garment, print: (entry, place) => ({...printMeasures(entry, place), ...print(entry, place)})},
    {title: projectTitle},
  )(value, at);
  return {...found, ...decisions(value, at)};
};

/** A sample's picture may have been redrawn for another group. */
const isSample = (print: DesignPrint): print is DesignPrint & {sample: object} =>
  print.sample !== undefined && !print.image.startsWith('data:');

/** "#...", of whatever length. @param title what its owner calls it */
export async function linkOf(design: Design, title?: string): Promise<string> {
  const {garment: own, print: shown} = design;
  const {group, size, turnDeg, oneWay, cell, tile, unscaled} = shown;
  const project: LinkedProject = {
    garment: own.sample ? {sample: own.sample} : {name: own.name, text: own.text},
    print: {
      ...{group, size, turnDeg, oneWay, cell, ...(unscaled && {unscaled})},
      ...(isSample(shown)
        ? {sample: shown.sample}
        : {title: shown.title, ...(tile ? {tile} : {image: shown.image})}),
    },
    ...decisionsOf(design),
    ...(title !== undefined && {title}),
  };
  return start + (await deflated(JSON.stringify(written(project))));
}

/**
 * Undefined for a fragment that means no project.
 * @throws {LinkError} for one that does, and is damaged or too large
 */
export async function readLink(fragment: string): Promise<LinkedProject | undefined> {
  const isPlain = fragment.startsWith(plainStart);
  if (!isPlain && !fragment.startsWith(start)) return undefined;
  try {
    if (fragment.length > longestLink) throw new LinkError('too long');
    return isPlain
      ? fromPlain(plainText(fragment.slice(plainStart.length)))
      : linked(JSON.parse(await inflated(fragment.slice(start.length), largest)), '');
  } catch (cause) {
    const isDamaged = [LinkError, Inflated, SyntaxError, TypeError, Malformed].some(
      (kind) => cause instanceof kind,
    );
    throw isDamaged ? new LinkError('damaged', {cause}) : cause;
  }
}

const plainText = (letters: string): string =>
  new TextDecoder('utf-8', {fatal: true}).decode(bytesOf(letters.replace(/=+$/, '')));

/** The garment was the name of a sample itself. */
function fromPlain(json: string): LinkedProject {
  const value: unknown = JSON.parse(json);
  const {garment: sample} = shape({garment: garmentSample})(value, '');
  return linked({...Object(value), garment: {sample}}, '');
}
