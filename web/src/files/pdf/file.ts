/** Assembles a PDF file from pages: catalog, page labels and initial view. */
import {packageVersion} from '../../model/base/version.js';
import {num, pointsPerCm} from './content.js';
import type {OtherLetters} from './fonts/other-letters.js';
import {dateString, refTo, textString, type PdfDocument, type Ref} from './document.js';
import type {PdfResources} from './resources.js';

interface PdfPage {
  readonly widthCm: number;
  readonly heightCm: number;
  /** The page label in viewers. */
  readonly label: string;
  readonly content: () => string;
}

interface PdfFileOptions {
  readonly title: string;
  /** Creation date. Without it, the same pages give the same bytes. */
  readonly date?: Date;
  /** Initial panel of viewers: layers, or none. */
  readonly mode: 'UseOC' | 'UseNone';
  /** Builds the document outline after the pages. */
  readonly outline?: (pages: readonly Ref[]) => Ref;
  /** Letters that the embedded font does not have. */
  readonly letters?: OtherLetters;
  /** Language of the texts. Default 'en'. */
  readonly locale?: string;
}

interface PdfBytes {
  readonly bytes: Uint8Array<ArrayBuffer>;
  /** Letters that no font has, which are written without accents or as '?'. */
  readonly missing: readonly string[];
}

/** A sentence about missing letters, if there are any. */
export const missingNotes = (letters: readonly string[]): readonly string[] =>
  letters.length === 0
    ? []
    : [
        `No font has the letters ${letters.join(' ')}, so they are written without accents or as '?'; name a font file that has them.`,
      ];

/** Yields the thread between pages. */
const pause = (): Promise<void> => new Promise((resolve) => setTimeout(resolve));

/**
 * Writes the file.
 * @param resources resources of all pages, finished here
 */
export async function pdfFile(
  document: PdfDocument,
  resources: PdfResources,
  pages: readonly PdfPage[],
  {title, date, mode, outline: outlineOf, letters, locale = 'en'}: PdfFileOptions,
): Promise<PdfBytes> {
  const tree = document.reserve();
  const refs: Ref[] = [];
  for (const {widthCm, heightCm, content: contentOf} of pages) {
    const content = document.stream('', contentOf());
    const size = [widthCm, heightCm].map((side) => num(side * pointsPerCm)).join(' ');
    refs.push(
      document.add(
        `<</Type/Page/Parent ${refTo(tree)}/MediaBox[0 0 ${size}]/Resources ${refTo(resources.ref)}/Contents ${refTo(content)}>>`,
      ),
    );
    await pause();
  }
  const missing = await resources.finish(letters);
  document.set(tree, `<</Type/Pages/Count ${refs.length}/Kids[${refs.map(refTo).join(' ')}]>>`);
  const labels = pages.map(({label}, k) => `${k}<</P ${textString(label)}>>`);
  const outline = outlineOf?.(refs);
  const catalog = document.add(
    [
      `<</Type/Catalog/Pages ${refTo(tree)}${outline === undefined ? '' : `/Outlines ${refTo(outline)}`}/Lang${textString(locale)}`,
      `/PageLabels<</Nums[${labels.join('')}]>>/OCProperties ${resources.optionalContent}`,
      // viewers preselect true size for printing
      `/ViewerPreferences<</PrintScaling/None/DisplayDocTitle true>>`,
      `/PageMode/${mode}>>`,
    ].join('\n'),
  );
  const info = document.add(
    `<</Title ${textString(title)}/Creator ${textString(`Seamwise ${packageVersion}`)}${date ? `/CreationDate ${dateString(date)}` : ''}>>`,
  );
  return {bytes: await document.bytes(catalog, info), missing};
}
