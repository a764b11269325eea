/** The repeat of a design's print as a file for print shops. */
import {printOf, type DesignPrint} from '../../model/design/design.js';
import {rectangularRepeat} from '../../model/print/rectangular-repeat.js';
import {checkScaled} from '../../model/result/unscaled-print.js';
import {embeddedTile} from '../../image/embedded-tile.js';
import {repeatPicture} from '../../image/repeat-picture.js';
import {repeatSvg} from '../../picture/repeat-svg.js';
import type {Texts} from '../../texts/texts.js';

/** Kinds of files: PNG with its resolution, and SVG. */
export type RepeatKind = number | 'svg';

/** Resolutions that print shops ask for, and SVG. */
export const repeatKinds: readonly RepeatKind[] = [150, 300, 'svg'];

interface RepeatFile {
  readonly content: Blob;
  /** Suffix of the file name. */
  readonly ending: string;
  /** A sentence about a file that is no rectangular repeat. */
  readonly note?: string;
}

/**
 * Makes a file of the repeat in its present size and turn.
 * @throws {SolverError} `unscaled` for a print of unknown size
 * @throws {Error} one sentence, if there is no such picture
 */
export async function repeatFile(
  print: DesignPrint,
  kind: RepeatKind,
  words: Texts['repeat'],
): Promise<RepeatFile> {
  const cell = printOf(print);
  checkScaled(cell);
  const tile = await embeddedTile(print.image);
  const rectangle = rectangularRepeat(cell);
  if (kind === 'svg') {
    const svg = repeatSvg({...cell, tile}, rectangle);
    return {
      content: new Blob([svg], {type: 'image/svg+xml'}),
      ending: 'repeat.svg',
      ...(!rectangle && {note: words.pattern}),
    };
  }
  if (!rectangle) throw new Error(words.none);
  const content = await repeatPicture(cell, tile, rectangle, kind);
  if (!content) throw new Error(words.tooLarge);
  return {content, ending: `repeat-${kind}dpi.png`};
}
