/** What the core could not do, in the language of the user; in English where that is not known here. */
import {SolverError, type Failure} from '../model/failure.js';
import {carries, groupsThatCarry} from '../model/repeat.js';
import type {Texts} from '../texts/texts.js';
import type {Workbench} from './workbench.js';

/** Why a symmetry does not hold; undefined for what is no such reason. */
export const symmetryReason = ({notes}: Texts, code: string | undefined): string | undefined =>
  Object.entries(notes.why).find(([name]) => name === code)?.[1];

/** Of a file that is something else, as far as its text tells. */
const otherFiles: ReadonlySet<string> = new Set(['notJson', 'notAGarment', 'noPanels']);
/** Of a garment's file with a fault in it. */
const garmentFaults: ReadonlySet<string> = new Set([
  ...['tooLarge', 'units', 'number', 'edgeIndex', 'edgeZeroLength', 'curvature', 'outlineOpen'],
  ...['outlineSelfIntersects', 'seamUnknownPiece', 'seamUnknownEdge', 'seamEdgeTwice'],
  ...['seamMalformed', 'mesh'],
]);

/**
 * What went wrong in a solve.
 * @param pieces labels of those whose symmetry is to blame, where that is known better than by the failure
 */
export function spokenFailure(
  {code, message, piece, reason}: Failure,
  {design, scenes}: Workbench,
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

/** The same as an error. */
export const spokenError = (failure: Failure, workbench: Workbench, texts: Texts): SolverError =>
  new SolverError({...failure, message: spokenFailure(failure, workbench, texts)});
