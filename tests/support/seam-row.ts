import type {SeamRow} from '@/workbench/lists/rows.js';

/** A row of the table of seams with only its number and its mismatch. [cm] */
export const seamRow = (seam: number, after: number, counts = true): SeamRow => ({
  ...{
    seam,
    letter: 'A',
    name: '',
    between: undefined,
    sides: ['', ''],
    length: 1,
    before: 0,
    after,
  },
  ...{worst: 0, gathered: false, drift: undefined, why: undefined, severity: 0},
  ...{kind: 'continuous', weight: 1, ownWeight: 1, matched: true},
  ...{canMatch: true, keptOn: [], counts},
});
