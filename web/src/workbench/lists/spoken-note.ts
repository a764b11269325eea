/** Notes of the core in the user's language; unknown notes stay in English. */
import type {NoteDetail} from '../../model/result/notes.js';
import {seamRows} from './rows.js';
import type {Format} from '../../texts/format.js';
import type {Texts} from '../../texts/texts.js';
import {symmetryReason} from '../spoken-failure.js';
import type {Workbench} from '../workbench.js';

const joined = (names: readonly (string | undefined)[]): string =>
  names.filter((name) => name !== undefined).join(', ');

/** @param sentence the note as written by the core */
export function spokenNote(
  sentence: string,
  detail: NoteDetail | undefined,
  workbench: Workbench,
  texts: Texts,
  format: Format,
): string {
  if (!detail) return sentence;
  const {notes} = texts;
  const {code, numbers} = detail;
  const labels = detail.pieces.map((piece) => workbench.sheet.scenes?.now.pieces[piece]?.label);
  const rows = seamRows(workbench, texts);
  const seams = joined(detail.seams.map((seam) => rows[seam]?.name));
  const [stated = '', drafted = ''] = numbers.map((number) => format.number(number, 2));
  const pairs = labels.flatMap((label, k) =>
    k % 2 === 0 ? [texts.symmetry.both(label ?? '', labels[k + 1] ?? '')] : [],
  );
  const why = symmetryReason(texts, code);
  if (why !== undefined) return notes.dropped(joined(labels), why);
  switch (code) {
    case 'gathered':
      return notes.gathered(seams);
    case 'lengthRatio':
      return notes.lengthRatio(seams, stated, drafted);
    case 'noMirrors':
      return notes.noMirrors(joined(labels));
    case 'noGlides':
      return notes.noGlides(joined(pairs));
    case 'grainAssumed':
      return notes.grainAssumed(joined(labels));
    case 'pleatsFitted':
    case 'pleatsOff': {
      const [before = '', whole = ''] = numbers.map((cm) => format.length(cm));
      return notes[code](joined(labels), before, whole);
    }
    case 'pleatsOffGrain':
    case 'pleatsUndivided':
    case 'pleatsUneven':
      return notes[code](joined(labels));
    case 'noSeams':
    case 'noMatchedSeams':
    case 'unitsAssumed':
    case 'curvesAssumed':
    case 'symmetriesStated':
    case 'ws19':
    case 'partOfTheWay':
    case 'leftAsDrafted':
      return notes[code];
    default:
      return sentence;
  }
}
