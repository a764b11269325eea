/** Choices of the gallery: the 17 groups, and stripes, which have no group of their own. */
import {groupNames} from '../model/base/core-tables.js';
import {askedSymmetries, type Decisions, type DesignPrint} from '../model/design/design.js';
import {type GroupName} from '../model/print/repeating-print.js';
import {alongStripe, carries, type SymmetryKind} from '../model/print/repeat.js';

export type Choice = GroupName | 'stripes';

export const choices: readonly Choice[] = [...groupNames, 'stripes'];

export const groupOf = (choice: Choice): GroupName => (choice === 'stripes' ? 'pmm' : choice);

/** Returns the print that represents a choice. */
export const sampleOf = (choice: Choice): string => (choice === 'stripes' ? 'ticking' : choice);

export const choiceOf = ({group, size}: Pick<DesignPrint, 'group' | 'size'>): Choice =>
  ['pm', 'pmm'].includes(group) && size.height <= alongStripe ? 'stripes' : group;

/** Returns the symmetry that the design requires and this group lacks; the harder one of two. */
export function missing(
  group: GroupName,
  design: Pick<Decisions, 'symmetry'> | undefined,
): SymmetryKind | undefined {
  const symmetries = design ? askedSymmetries(design) : [];
  return (['piece', 'pair'] as const).find(
    (kind) => symmetries.some((one) => one.kind === kind) && !carries(group, kind),
  );
}
