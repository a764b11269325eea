/** Copies a link to the current project to the clipboard. */
import type {Design} from '../../model/design/design.js';
import {linkOf, longestLink} from '../../model/documents/link.js';
import {textsOf} from '../../texts/texts.js';
import type {Workbench} from '../../workbench/workbench.js';
import type {Projects} from '../projects/projects.js';
import {smaller} from './pictures.js';

/** Length from which mail programs and chats may truncate a link. [characters] */
const safeLength = 2000;
/** Longer sides that are tried for the image of a link that is too long. [px] */
const sides = [1024, 512, 256];

interface Link {
  readonly text: string;
  readonly hasSmallerPicture: boolean;
}

async function shortest(
  design: Design,
  title: string | undefined,
  hasPattern: boolean,
): Promise<Link> {
  let text = await linkOf(design, title, hasPattern);
  let hasSmallerPicture = false;
  for (const side of sides) {
    if (text.length <= longestLink) break;
    const {image: own, tile} = design.print;
    const carried = tile?.image ?? own;
    const image = carried.startsWith('data:') && (await smaller(carried, side));
    if (!image) continue;
    hasSmallerPicture = true;
    const made = tile ? {tile: {...tile, image}} : {image};
    text = await linkOf({...design, print: {...design.print, ...made}}, title, hasPattern);
  }
  return {text, hasSmallerPicture};
}

/**
 * Copies the link and reports its length; rejects one that is too long. A pattern is somebody's
 * work: the link leaves out one that is no sample, until the user says that it is theirs to share.
 */
export async function copyLink(
  workbench: Workbench,
  projects: Projects,
  hasPattern = false,
): Promise<void> {
  const {design} = workbench.history;
  if (!design) return;
  const {link} = textsOf(workbench.preferences.chosen.language);
  const {text, hasSmallerPicture} = await shortest(design, projects.present?.title, hasPattern);
  const {href} = new URL(text, location.href);
  const size = `${Math.ceil(href.length / 1000).toLocaleString(workbench.preferences.chosen.language)} kB`;
  if (text.length > longestLink) {
    workbench.notices.say({tone: 'error', text: link.tooLong(size)});
    return;
  }
  try {
    await navigator.clipboard.writeText(href);
  } catch {
    workbench.notices.say({tone: 'error', text: link.notCopied});
    return;
  }
  const said = [
    href.length > safeLength ? link.long(size) : link.copied,
    ...(hasSmallerPicture ? [link.smaller] : []),
  ];
  const {garment, added = []} = design;
  if (hasPattern || [garment, ...added.map((one) => one.garment)].every(({sample}) => sample)) {
    workbench.notices.say({tone: 'info', text: said.join(' ')});
    return;
  }
  workbench.notices.say({
    tone: 'info',
    text: [...said, link.withoutPattern].join(' '),
    action: {label: link.mine, act: () => void copyLink(workbench, projects, true)},
  });
}
