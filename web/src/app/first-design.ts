/** The page's first design: the files in its URL, or the opening sample. */
import type {Design} from '../model/design/design.js';
import {readPrintFile} from '../model/print/read-print-file.js';
import {
  newDesign,
  opening,
  sampleGarment,
  samplePrint,
  welcome,
  type Samples,
} from '../workbench/samples.js';
import type {Workbench} from '../workbench/workbench.js';

/** @throws {Error} if a sample cannot be read; the message is one sentence */
export const firstDesign = (samples: Promise<Samples>): Promise<Design> =>
  sampleDesign(samples, opening);

/**
 * Returns the design for a first visit, without symmetries.
 * @throws {Error} if a sample cannot be read; the message is one sentence
 */
export const welcomeDesign = (samples: Promise<Samples>): Promise<Design> =>
  sampleDesign(samples, welcome);

async function sampleDesign(
  samples: Promise<Samples>,
  shown: typeof opening | typeof welcome,
): Promise<Design> {
  const [garment, {prints}] = await Promise.all([sampleGarment(shown.style, shown.size), samples]);
  const print = prints.find(({name}) => name === shown.print);
  if (!print) throw new Error('The list of samples lacks the first print; load the page again.');
  return newDesign(garment, samplePrint(print));
}

/**
 * Returns a design of the files in `?garment=URL&print=URL`.
 * @throws {Error} a message of one sentence
 */
export async function askedFor(
  address: URL,
  before: Design,
  solver: Workbench['solver'],
): Promise<Design | undefined> {
  const [garment, print] = ['garment', 'print'].map((name) => address.searchParams.get(name));
  if (!garment && !print) return undefined;
  const file = garment ? await fetched(garment, address) : undefined;
  return newDesign(
    file ? {name: file.name, text: await file.text()} : before.garment,
    print ? await askedPrint(print, address, solver) : before.print,
  );
}

/** Embeds the image of a print file, so that the design can be saved as a whole. */
async function askedPrint(
  path: string,
  address: URL,
  solver: Workbench['solver'],
): Promise<Design['print']> {
  const file = await fetched(path, address);
  const {readPrint} = await import('../print/read-print.js');
  const print = await readPrint(solver, file);
  if (!path.endsWith('.json')) return print;
  const {image} = readPrintFile(await file.text(), path);
  if (!image || image.startsWith('data:')) return print;
  const picture = new URL(image, new URL(path, address));
  return {...print, image: (await readPrint(solver, await fetched(picture.href, address))).image};
}

async function fetched(path: string, address: URL): Promise<File> {
  const url = new URL(path, address);
  if (url.origin !== address.origin) {
    throw new Error(
      `${path} is on another host; copy the file to ${address.host} and name it there.`,
    );
  }
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${path} cannot be read; check the address.`);
  const blob = await response.blob();
  return new File([blob], url.pathname.split('/').at(-1) ?? path, {type: blob.type});
}
