/** A failure of the core in the user's language; in English where a translation is missing. */
import {drapeReasons, layReasons, SolverError, type Failure} from '../model/base/failure.js';
import {carries} from '../model/print/repeat.js';
import {formatFor, type Format} from '../texts/format.js';
import type {Texts} from '../texts/texts.js';
import type {Workbench} from './workbench.js';

/** Reason why a symmetry does not hold; undefined for any other code. */
export const symmetryReason = ({notes}: Texts, code: string | undefined): string | undefined =>
  Object.entries(notes.why).find(([name]) => name === code)?.[1];

/** Message for pieces that cannot be laid; undefined for another reason. */
function spokenLay(
  {reason, lengthCm}: Failure,
  label: string,
  {failures}: Texts,
  format: Format,
): string | undefined {
  const known = layReasons.find((one) => one === reason);
  if (!known) return undefined;
  const words = failures.lay[known](label);
  return lengthCm === undefined ? words : `${words} ${failures.atLeast(format.length(lengthCm))}`;
}

/**
 * Message for a failed solve.
 * @param pieces labels of the pieces with the failing symmetry, if they are known better than from
 * the failure
 */
export function spokenFailure(
  failure: Failure,
  {history: {design}, sheet: {scenes}, preferences}: Workbench,
  texts: Texts,
  pieces?: string,
): string {
  const {code, message, piece, reason} = failure;
  const {failures, notes, symmetry} = texts;
  const why = symmetryReason(texts, reason);
  const label = pieces ?? scenes?.now.pieces[piece ?? -1]?.label;
  if (why !== undefined && label !== undefined) return notes.cannotHold(label, why);
  if (code === 'symmetryGroup' && design) {
    const {group} = design.print;
    const kind = carries(group, 'pair') ? 'piece' : 'pair';
    return symmetry.lacks[kind];
  }
  const {language, units} = preferences.chosen;
  const lay =
    label === undefined ? undefined : spokenLay(failure, label, texts, formatFor(language, units));
  if (lay !== undefined) return lay;
  const drape = drapeReasons.find((one) => one === reason);
  if (drape && (label !== undefined || piece === null)) return failures.drape[drape](label ?? '');
  if (code === 'unscaled') return texts.print.unscaled;
  const words = Object.entries(failures.codes).find(([name]) => name === code)?.[1];
  return words?.(message) ?? message;
}

/** The failure as an error with this message. */
export const spokenError = (failure: Failure, workbench: Workbench, texts: Texts): SolverError =>
  new SolverError({...failure, message: spokenFailure(failure, workbench, texts)});
