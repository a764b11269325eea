import type {PdfResources} from '../files/pdf/resources.js';
import type {SheetTexts} from '../texts/sheet-texts.js';

/** What text on pages needs: the fonts of the file, and words in the user's language. */
export interface Writing {
  readonly resources: PdfResources;
  readonly texts: SheetTexts;
}
