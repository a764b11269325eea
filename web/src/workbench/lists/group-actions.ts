/** Decisions on a line of the list of seams, each as one step of the history. */
import {isKept, keptParts, toggledLock} from '../../model/design/locks.js';
import type {SolveOptions} from '../../model/design/options.js';
import type {Remedy} from '../../remedies/remedy.js';
import {remedied, remedyName} from '../remedies/remedied.js';
import type {Format} from '../../texts/format.js';
import type {Texts} from '../../texts/texts.js';
import type {Workbench} from '../workbench.js';
import {withImportance, type Importance} from './changed-options.js';
import {edgesOf, type GroupRow} from './group-rows.js';

/** Greatest change of an outline that an option permits. [cm] */
const defaultChange = 1;

export function decide(
  {history}: Pick<Workbench, 'history'>,
  {seams}: Pick<GroupRow, 'seams'>,
  importance: Importance,
): void {
  const {design} = history;
  if (design) history.change({options: withImportance(design.options, seams, importance)});
}

/** Keeps the outlines on both sides of a seam as drafted, or releases them. */
export function toggleOutline(
  {history, solving: {pattern}}: Pick<Workbench, 'history' | 'solving'>,
  {seams, kept}: Pick<GroupRow, 'seams' | 'kept'>,
): void {
  const {design} = history;
  if (!design || !pattern) return;
  const parts = seams.flatMap((seam) => {
    const {a, b} = pattern.seams[seam] ?? {};
    return [...edgesOf(pattern, a), ...edgesOf(pattern, b)];
  });
  const options = parts.reduce(
    (all: SolveOptions, part) =>
      isKept(keptParts(pattern, all.locked), part) === kept ? toggledLock(all, pattern, part) : all,
    design.options,
  );
  history.change({options});
}

/** A change that may make a seam match, at one click. */
interface WayOut {
  readonly text: string;
  readonly act: () => void;
}

/** The remedy of the reason why a line does not match. */
export function wayOut(
  workbench: Workbench,
  row: GroupRow,
  texts: Texts,
  format: Format,
): WayOut | undefined {
  const {history, afterwards} = workbench;
  const {design} = history;
  if (!design) return undefined;
  const {remedies} = texts;
  switch (row.reason) {
    case 'grain': {
      const remedy = afterwards.remedies(design).find((one) => isInLine(one, row));
      const change = remedy && remedied(design, remedy, undefined);
      if (!change) return undefined;
      return {
        text: remedyName(remedy, workbench, texts),
        act: () => {
          history.change(change);
        },
      };
    }
    case 'others':
      return row.importance === 'first' || !row.canMatch
        ? undefined
        : {
            text: remedies.first,
            act: () => {
              decide(workbench, row, 'first');
            },
          };
    case 'locked':
      return row.kept
        ? {
            text: remedies.release,
            act: () => {
              toggleOutline(workbench, row);
            },
          }
        : undefined;
    case 'reach': {
      const maxChangeCm = 2 * (design.options.maxChangeCm ?? defaultChange);
      return {
        text: remedies.allow(format.length(maxChangeCm)),
        act: () => {
          history.change({options: {...design.options, maxChangeCm}});
        },
      };
    }
    default:
      return undefined;
  }
}

/** Returns whether a line offers a remedy; the other remedies are listed below the headline. */
export const isInLine = ({kind, seams}: Remedy, row: GroupRow): boolean =>
  kind === 'turn' && row.isVisible && row.seams.some((seam) => seams.includes(seam));

/** The reason why a line does not match, or the end that does not, in words. */
export function reasonOf(
  {history: {design}}: {readonly history: Pick<Workbench['history'], 'design'>},
  {state, reason, end, importance}: GroupRow,
  {lists, remedies}: Texts,
  format: Format,
): string | undefined {
  if (state === undefined) return undefined;
  if (state === 'choice') {
    if (reason === 'gather') return remedies.why.gather;
    return importance === 'none' ? lists.yourChoice : undefined;
  }
  if (end) return lists.butFor[end.from](format.length(end.cm));
  if (reason === undefined || state === 'matches') return undefined;
  return reason === 'reach'
    ? remedies.why.reach(format.length(design?.options.maxChangeCm ?? defaultChange))
    : remedies.why[reason];
}
