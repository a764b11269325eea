/** Notes on a drape in the user's language; those of a stored drape stay in English. */
import type {Drape, DrapeNote} from '../../model/result/draped-garment.js';
import type {DrapeTexts} from '../../texts/drape-texts.js';
import type {Format} from '../../texts/format.js';

export const spokenDrapeNotes = (
  {notes, noteDetails = []}: Pick<Drape, 'notes' | 'noteDetails'>,
  words: DrapeTexts,
  format: Format,
): readonly string[] =>
  notes.map((sentence, k) => {
    const detail = noteDetails[k];
    return (detail && spoken(detail, words, format)) ?? sentence;
  });

/** Returns undefined for a code of a newer solver. */
function spoken(
  {code, number}: DrapeNote,
  {notes}: DrapeTexts,
  format: Format,
): string | undefined {
  switch (code) {
    case 'drapeMoving':
      return notes[code](format.fine(number));
    case 'drapeCrossings':
      return notes[code](number);
    case 'drapeNoStart':
    case 'drapeBySeams':
      return notes[code];
    default:
      return undefined;
  }
}
