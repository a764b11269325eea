import {PdfDocument} from '@/files/pdf/document.js';
import {PdfResources} from '@/files/pdf/resources.js';

/** Resources whose text operators contain the text in brackets, as in "(Apron, M)". */
export function readableText(): PdfResources {
  const resources = new PdfResources(new PdfDocument());
  const fonts = {shown: (text: string) => `(${text})`};
  return Object.defineProperty(resources, 'fonts', {value: fonts});
}
