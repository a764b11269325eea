/** Assembles a PDF file from pages: catalog, page labels and initial view. */
import {packageVersion} from '../../model/base/version.js';
import {num, pointsPerCm} from './content.js';
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
}

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
  {title, date, mode, outline: outlineOf}: PdfFileOptions,
): Promise<Uint8Array<ArrayBuffer>> {
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
  resources.finish();
  document.set(tree, `<</Type/Pages/Count ${refs.length}/Kids[${refs.map(refTo).join(' ')}]>>`);
  const labels = pages.map(({label}, k) => `${k}<</P ${textString(label)}>>`);
  const outline = outlineOf?.(refs);
  const catalog = document.add(
    [
      `<</Type/Catalog/Pages ${refTo(tree)}${outline === undefined ? '' : `/Outlines ${refTo(outline)}`}/Lang(en)`,
      `/PageLabels<</Nums[${labels.join('')}]>>/OCProperties ${resources.optionalContent}`,
      // viewers preselect true size for printing
      `/ViewerPreferences<</PrintScaling/None/DisplayDocTitle true>>`,
      `/PageMode/${mode}>>`,
    ].join('\n'),
  );
  const info = document.add(
    `<</Title ${textString(title)}/Creator ${textString(`Seamwise ${packageVersion}`)}${date ? `/CreationDate ${dateString(date)}` : ''}>>`,
  );
  return document.bytes(catalog, info);
}
