/** Types of figures.mjs, for its tests. */
import type {GarmentDocument} from '../../web/src/model/garment/garment-document.js';
import type {SeamSuggestions} from '../../web/src/pairing/report.js';
import type {mirrorImage} from '../../web/src/pairing/image.js';
import type {likeliestSeams} from '../../web/src/pairing/suggest.js';

export class Figures {
  readonly shares: {
    readonly first: number;
    readonly amongThree: number;
    readonly sureRight: number;
    readonly found: number;
  };
  add(document: GarmentDocument, suggestions: SeamSuggestions): void;
}

export function dialogue(
  pairing: {likeliestSeams: typeof likeliestSeams; mirrorImage: typeof mirrorImage},
  document: GarmentDocument,
): {
  readonly seams: number;
  readonly questions: number;
  readonly sewn: number;
  readonly followed: number;
  readonly wrong: number;
};
