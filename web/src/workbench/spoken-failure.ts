/** A failure of the core in the user's language; in English where a translation is missing. */
import {SolverError, type Failure} from '../model/result/failure.js';
import {carries, groupsThatCarry} from '../model/print/repeat.js';
import type {Texts} from '../texts/texts.js';
import type {Workbench} from './workbench.js';

/** Reason why a symmetry does not hold; undefined for any other code. */
export const symmetryReason = ({notes}: Texts, code: string | undefined): string | undefined =>
  Object.entries(notes.why).find(([name]) => name === code)?.[1];

/** Failures of a file of another kind, as far as its text shows. */
const otherFiles: ReadonlySet<string> = new Set(['notJson', 'notAGarment', 'noPanels']);
/** Failures of a garment file with an error. */
const garmentFaults: ReadonlySet<string> = new Set([
  ...['tooLarge', 'units', 'number', 'edgeIndex', 'edgeZeroLength', 'curvature', 'outlineOpen'],
  ...['outlineSelfIntersects', 'seamUnknownPiece', 'seamUnknownEdge', 'seamEdgeTwice'],
  ...['seamMalformed', 'mesh'],
]);

/**
 * Message for a failed solve.
 * @param pieces labels of the pieces with the failing symmetry, if they are known better than from
 * the failure
 */
export function spokenFailure(
  {code, message, piece, reason}: Failure,
  {history: {design}, sheet: {scenes}}: Workbench,
  texts: Texts,
  pieces?: string,
): string {
  const {failures, notes, symmetry} = texts;
  const why = symmetryReason(texts, reason);
  const label = pieces ?? scenes?.now.pieces[piece ?? -1]?.label;
  if (why !== undefined && label !== undefined) return notes.cannotHold(label, why);
  if (code === 'symmetryGroup' && design) {
    const {group} = design.print;
    const kind = carries(group, 'pair') ? 'piece' : 'pair';
    return symmetry.lacks[kind](group, groupsThatCarry(kind).join(', '));
  }
  if (otherFiles.has(code)) return failures.noGarment(message);
  if (garmentFaults.has(code)) return failures.garment(message);
  switch (code) {
    case 'internal':
      return failures.solver(message);
    case 'no-wasm':
      return failures.noWasm(message);
    case 'worker-blocked':
      return failures.noWorker(message);
    case 'unscaled':
      return texts.print.unscaled;
    default:
      return message;
  }
}

/** The failure as an error with this message. */
export const spokenError = (failure: Failure, workbench: Workbench, texts: Texts): SolverError =>
  new SolverError({...failure, message: spokenFailure(failure, workbench, texts)});
