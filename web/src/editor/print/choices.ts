/** Choices of the gallery: the 17 groups, and stripes, which have no group of their own. */
import {askedSymmetries, type Decisions, type DesignPrint} from '../../model/design.js';
import {groupNames, type GroupName} from '../../model/print.js';
import {carries, latticeVectors, type SymmetryKind} from '../../model/repeat.js';
import {printElements} from '../../model/wallpaper.js';

export type Choice = GroupName | 'stripes';

export const choices: readonly Choice[] = [...groupNames, 'stripes'];

/** Any repeat is valid along a stripe; this one represents all. [cm] */
export const alongStripe = 0.5;

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

/** Returns whether every print of this group looks the same upside down. */
export function turnsOver(group: GroupName): boolean {
  const [w1, w2] = latticeVectors(group, {width: 1, height: 1, angleDeg: 90});
  return printElements({group, w1, w2}).some(
    ({xx, yy}) => Math.abs(xx + 1) < 1e-9 && Math.abs(yy + 1) < 1e-9,
  );
}
