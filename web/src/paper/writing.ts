import type {PdfResources} from '../files/pdf/resources.js';
import type {SheetTexts} from '../texts/sheet-texts.js';

/** Fonts of a file, and words in the user's language, for text on its pages. */
export interface Writing {
  readonly resources: PdfResources;
  readonly texts: SheetTexts;
}
