/** Written by the core, `npm run tables`: the 17 wallpaper groups, and what options may be. */

export const groupNames = [
  'p1',
  'p2',
  'pm',
  'pg',
  'cm',
  'pmm',
  'pmg',
  'pgg',
  'cmm',
  'p4',
  'p4m',
  'p4g',
  'p3',
  'p3m1',
  'p31m',
  'p6',
  'p6m',
] as const;

/** Lattice type, order of the point group, generators (u, v) -> M (u, v) + a in lattice coordinates: M by rows, a. */
export const groupTable = {
  p1: ['oblique', 1, []],
  p2: ['oblique', 2, [[-1, 0, 0, -1, 0, 0]]],
  pm: ['rectangular', 2, [[1, 0, 0, -1, 0, 0]]],
  pg: ['rectangular', 2, [[1, 0, 0, -1, 0.5, 0]]],
  cm: ['rhombic', 2, [[0, 1, 1, 0, 0, 0]]],
  pmm: ['rectangular', 4, [[-1, 0, 0, -1, 0, 0], [1, 0, 0, -1, 0, 0]]],
  pmg: ['rectangular', 4, [[-1, 0, 0, -1, 0, 0], [1, 0, 0, -1, 0, 0.5]]],
  pgg: ['rectangular', 4, [[-1, 0, 0, -1, 0, 0], [1, 0, 0, -1, 0.5, 0.5]]],
  cmm: ['rhombic', 4, [[-1, 0, 0, -1, 0, 0], [0, 1, 1, 0, 0, 0]]],
  p4: ['square', 4, [[0, -1, 1, 0, 0, 0]]],
  p4m: ['square', 8, [[0, -1, 1, 0, 0, 0], [1, 0, 0, -1, 0, 0]]],
  p4g: ['square', 8, [[0, -1, 1, 0, 0, 0], [1, 0, 0, -1, 0.5, 0.5]]],
  p3: ['hexagonal', 3, [[-1, -1, 1, 0, 0, 0]]],
  p3m1: ['hexagonal', 6, [[-1, -1, 1, 0, 0, 0], [0, 1, 1, 0, 0, 0]]],
  p31m: ['hexagonal', 6, [[-1, -1, 1, 0, 0, 0], [1, 1, 0, -1, 0, 0]]],
  p6: ['hexagonal', 6, [[0, -1, 1, 1, 0, 0]]],
  p6m: ['hexagonal', 12, [[0, -1, 1, 1, 0, 0], [1, 1, 0, -1, 0, 0]]],
} as const;

/** The least and the most that an option may be. */
export const optionLimits = {
  maxChangeCm: [0, 50],
  edgeLengthCm: [0.1, 1.05],
  alpha: [1e-9, 1e9],
  effort: [1, 64],
  starts: [1, 1000],
  proof: [0, 1e6],
  toleranceDeg: [0, 90],
  weight: [0, 1e6],
  repeatCm: [0.05, 1000],
} as const;

/** A placing that costs no more than this share above what is proven is the best. */
export const provenShare = 0.001;
