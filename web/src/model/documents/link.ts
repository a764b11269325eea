/**
 * A project as the fragment of a URL, to be shared. It contains everything except the content of
 * samples.
 */
import {decisionsOf, type Design, type DesignGarment, type DesignPrint} from '../design/design.js';
import {
  decisions,
  garmentSample,
  onFabric,
  ownGarment,
  ownPicture,
  ownTile,
  printMeasures,
  printSample,
} from '../design/read-design.js';
import {written} from '../design/written-design.js';
import {projectTitle} from './project-name.js';
import {digestOf} from '../base/digest.js';
import {fieldOf, Malformed, shape, text, type Read} from '../base/read.js';
import type {PrintTile} from '../print/opened-image.js';
import {partsOf} from '../base/fetched.js';

// Deflated text in URL-safe letters, small enough for a URL.

/** Error for letters that are not a deflated text, or that inflate to more than the limit. */
class Inflated extends Error {
  override readonly name = 'Inflated';
}

async function deflated(text: string): Promise<string> {
  const stream = new Blob([text]).stream().pipeThrough(new CompressionStream('deflate-raw'));
  return base64url(new Uint8Array(await new Response(stream).arrayBuffer()));
}

/**
 * The inverse of `deflated`. Inflating stops beyond `most`, because a few kilobytes may expand to
 * gigabytes.
 * @param most limit of the inflated text [bytes]
 * @throws {Inflated}
 */
async function inflated(letters: string, most: number): Promise<string> {
  const stream = new Blob([bytesOf(letters)])
    .stream()
    .pipeThrough(new DecompressionStream('deflate-raw'));
  try {
    const parts = await partsOf(stream, most);
    if (!parts) throw new Inflated(`more than ${most} bytes`);
    const bytes = await new Blob(parts).arrayBuffer();
    return new TextDecoder('utf-8', {fatal: true}).decode(bytes);
  } catch (cause) {
    throw new Inflated('not a deflated text', {cause});
  }
}

function base64url(bytes: Uint8Array): string {
  const letters = Array.from(bytes, (byte) => String.fromCodePoint(byte)).join('');
  return btoa(letters).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
}

/** Decodes base64url. @throws {Inflated} for letters that are not base64url */
function bytesOf(letters: string): Uint8Array<ArrayBuffer> {
  if (!/^[\w-]*$/.test(letters) || letters.length % 4 === 1) throw new Inflated('no base64url');
  const bytes = atob(letters.replaceAll('-', '+').replaceAll('_', '/'));
  return Uint8Array.from(bytes, (byte) => byte.codePointAt(0) ?? 0);
}

/** A garment that its sender left out, since a pattern is somebody's work. */
interface LeftOutGarment extends Pick<DesignGarment, 'name'> {
  readonly sha256: string;
}

/** A garment in a link: the name of a sample, the whole garment, or one that is left out. */
export type LinkedGarment =
  | {readonly sample: NonNullable<DesignGarment['sample']>}
  | Pick<DesignGarment, 'name' | 'text'>
  | LeftOutGarment;

/**
 * A print in a link. If its image was made from an opened one, the link contains only the opened
 * one.
 */
export type LinkedPrint = Pick<
  DesignPrint,
  'group' | 'size' | 'turnDeg' | 'oneWay' | 'cell' | 'unscaled' | 'own' | 'isPrinted' | 'delivered'
> &
  (
    | {readonly sample: NonNullable<DesignPrint['sample']>}
    | Pick<DesignPrint, 'title' | 'image'>
    | (Pick<DesignPrint, 'title'> & {readonly tile: PrintTile})
  );

export interface LinkedProject extends Design<LinkedGarment, LinkedPrint> {
  /** Title given by the sender. */
  readonly title?: string;
}

/** Error for a fragment that is meant as a project but is damaged or too large. */
export class LinkError extends Error {
  override readonly name = 'LinkError';
}

const start = '#project=';
/** Start of older links, which are not deflated. */
const plainStart = '#design=';
/** Greatest length of a link, since browsers and servers limit URLs. [characters] */
export const longestLink = 200_000;
/** Greatest size of an inflated project. [bytes] */
const largest = 8 * 2 ** 20;

/** Chooses a reader by the presence of a field. */
const either =
  <A, B>(field: string, having: Read<A>, other: Read<B>): Read<A | B> =>
  (value, at) =>
    fieldOf(value, field) === undefined ? other(value, at) : having(value, at);

const title = text(/^.{0,255}$/su, 'a title');
const leftOut = shape({name: text(), sha256: text(/^[\da-f]{64}$/, 'a hash')});
const garment = either(
  'sample',
  shape({sample: garmentSample}),
  either('sha256', leftOut, ownGarment),
);
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
  return {...found, ...decisions(value, at), ...onFabric(garment)(value, at)};
};

/**
 * Returns whether a print is a sample with its original image. The image may have been redrawn for
 * another group.
 */
const isSample = (print: DesignPrint): print is DesignPrint & {sample: object} =>
  print.sample !== undefined && !print.image.startsWith('data:');

/** The garment in a link, whole only if it may be shared. */
async function linkedGarment(
  {sample, name, text}: DesignGarment,
  hasPattern: boolean,
): Promise<LinkedGarment> {
  if (sample) return {sample};
  if (hasPattern) return {name, text};
  return {name, sha256: await digestOf(text)};
}

/**
 * The fragment "#..." of a project, of any length.
 * @param title given by the owner
 * @param hasPattern includes garments that are no samples
 */
export async function linkOf(
  design: Design,
  title: string | undefined,
  hasPattern: boolean,
): Promise<string> {
  const {garment: own, print: shown, copies, added} = design;
  const {
    group,
    size,
    turnDeg,
    oneWay,
    cell,
    tile,
    unscaled,
    own: before,
    isPrinted,
    delivered,
  } = shown;
  const project: LinkedProject = {
    garment: await linkedGarment(own, hasPattern),
    print: {
      ...{group, size, turnDeg, oneWay, cell},
      ...(unscaled && {unscaled}),
      ...(before && {own: before}),
      ...(isPrinted && {isPrinted}),
      ...(delivered && {delivered}),
      ...(isSample(shown)
        ? {sample: shown.sample}
        : {title: shown.title, ...(tile ? {tile} : {image: shown.image})}),
    },
    ...decisionsOf(design),
    ...(copies !== undefined && {copies}),
    ...(added && {
      added: await Promise.all(
        added.map(async (one) => ({
          ...one,
          garment: await linkedGarment(one.garment, hasPattern),
        })),
      ),
    }),
    ...(title !== undefined && {title}),
  };
  return start + (await deflated(JSON.stringify(written(project))));
}

/**
 * Reads the project of a fragment; undefined for a fragment that is not a project.
 * @throws {LinkError} for a damaged or too large project
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

/** Reads an older link, in which the garment is the name of a sample. */
function fromPlain(json: string): LinkedProject {
  const value: unknown = JSON.parse(json);
  const {garment: sample} = shape({garment: garmentSample})(value, '');
  return linked({...Object(value), garment: {sample}}, '');
}
