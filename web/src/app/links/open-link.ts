/** Opens the project in a link. Nothing in it is trusted. */
import type {Design, DesignPrint} from '../../model/design/design.js';
import {
  LinkError,
  readLink,
  type LinkedGarment,
  type LinkedPrint,
} from '../../model/documents/link.js';
import {digestOf} from '../../model/base/digest.js';
import {pictureOfTile} from '../../print/own-print.js';
import {sampleGarment, samplePrint, type Samples} from '../../workbench/samples.js';
import {textsOf} from '../../texts/texts.js';
import type {Workbench} from '../../workbench/workbench.js';
import type {Projects} from '../projects/projects.js';
import {loaded} from './pictures.js';

/**
 * Opens the contents of a fragment as a separate project. An error changes nothing.
 * @returns false if the fragment contains no project
 * @throws {Error} if it cannot be opened; the message is one sentence
 */
export async function openLink(
  fragment: string,
  workbench: Workbench,
  projects: Projects,
  samples: Promise<Samples>,
): Promise<boolean> {
  const {link: words} = textsOf(workbench.preferences.chosen.language);
  try {
    const link = await readLink(fragment);
    if (!link) return false;
    const {title, garment, print, added, ...decided} = link;
    const known = await samples;
    const opened = (one: LinkedGarment) => garmentOf(one, known, projects, words);
    const design: Design = {
      ...decided,
      garment: await opened(garment),
      ...(added && {
        added: await Promise.all(
          added.map(async (one) => ({...one, garment: await opened(one.garment)})),
        ),
      }),
      print: await printOf(print, await samples, words.noSample),
    };
    await workbench.solving.meshed(design);
    projects.beginAsGiven(design, {origin: 'own', ...(title !== undefined && {title})});
    return true;
  } catch (error) {
    throw error instanceof LinkError ? new Error(words.damaged, {cause: error}) : error;
  }
}

type LinkTexts = ReturnType<typeof textsOf>['link'];

async function garmentOf(
  garment: LinkedGarment,
  {garments}: Samples,
  projects: Projects,
  words: LinkTexts,
): Promise<Design['garment']> {
  if ('sha256' in garment) {
    const known = await projects.findGarment(
      async ({text}) => (await digestOf(text)) === garment.sha256,
    );
    if (!known) throw new Error(words.leftOut(garment.name));
    return known;
  }
  if (!('sample' in garment)) return garment;
  const {style, size} = garment.sample;
  const known = garments.find((one) => one.style === style);
  if (!known?.sizes.includes(size)) throw new Error(words.noSample);
  return sampleGarment(style, size);
}

async function printOf(
  print: LinkedPrint,
  {prints}: Samples,
  missing: string,
): Promise<DesignPrint> {
  if (!('sample' in print)) {
    const isMade = 'tile' in print;
    await loaded(isMade ? print.tile.image : print.image).catch((cause: unknown) => {
      throw new LinkError('no picture', {cause});
    });
    return isMade ? {...print, image: await pictureOfTile(print.tile)} : print;
  }
  const known = prints.find(({name}) => name === print.sample.name);
  if (!known) throw new Error(missing);
  return {...samplePrint(known, print.sample.colourway), ...print};
}
