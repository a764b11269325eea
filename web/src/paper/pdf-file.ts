/** A PDF file of pages whose content is at hand: its catalog, labels of pages, and what readers show first. */
import {packageVersion} from '../model/version.js';
import {num, pointsPerCm} from './pdf-content.js';
import {dateString, refTo, textString, type PdfDocument, type Ref} from './pdf-document.js';
import type {PdfResources} from './pdf-resources.js';

interface PdfPage {
  readonly widthCm: number;
  readonly heightCm: number;
  /** What readers call it. */
  readonly label: string;
  readonly content: () => string;
}

interface PdfFileOptions {
  readonly title: string;
  /** Without it the same pages give the same bytes. */
  readonly date?: Date;
  /** Whether readers show layers beside the pages at first. */
  readonly mode: 'UseOC' | 'UseNone';
  /** What readers list beside the pages, made once those are. */
  readonly outline?: (pages: readonly Ref[]) => Ref;
}

/** Lets others have the thread between pages. */
const pause = (): Promise<void> => new Promise((resolve) => setTimeout(resolve));

/** @param resources of all pages, which it finishes */
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
      // whoever prints is offered true size first
      `/ViewerPreferences<</PrintScaling/None/DisplayDocTitle true>>`,
      `/PageMode/${mode}>>`,
    ].join('\n'),
  );
  const info = document.add(
    `<</Title ${textString(title)}/Creator ${textString(`Seamwise ${packageVersion}`)}${date ? `/CreationDate ${dateString(date)}` : ''}>>`,
  );
  return document.bytes(catalog, info);
}
