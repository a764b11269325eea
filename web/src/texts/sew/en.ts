/** English texts of the sewing tool. */

export const sew = {
  begin: 'Choose an edge: click it, or press Tab. N goes to the longest that is not sewn.',
  edges: 'Edges',
  places: {
    right: 'Right side',
    upperRight: 'Upper right',
    top: 'Top',
    upperLeft: 'Upper left',
    left: 'Left side',
    lowerLeft: 'Lower left',
    bottom: 'Bottom',
    lowerRight: 'Lower right',
  },
  edge: (place: string, piece: string) => `${place} of ${piece}`,
  run: (count: number, first: string) => `${count} edges from ${first}`,
  both: (one: string, other: string) => `${one} with ${other}`,
  chosen: (edge: string, length: string) => `${edge}, ${length}.`,
  best: (edge: string, length: string) => `Best match: ${edge}, ${length}. Press 1 to sew.`,
  bestWith: (more: string, edge: string, length: string) =>
    `Best match: with ${more} to ${edge}, ${length}. Press 1 to sew.`,
  noMatch:
    'Nothing is like it. Press Enter and choose what it is sewn to, or H: it stays open. Shift ← → joins edges.',
  held: 'Now choose what it is sewn to, or press 1 to 5. Shift ← → joins edges.',
  preview: (edge: string, ease: string) => `To ${edge}, ${ease}. Press Enter to sew.`,
  ease: (length: string) => `ease ${length}`,
  noEase: 'the same length',
  turned: 'The other way round.',
  sewnTo: (edge: string, ease: string) =>
    `Sewn to ${edge}, ${ease}. R turns it, Delete takes it apart.`,
  staysOpen: 'Stays open.',
  count: (sewn: number, all: number, open: number) => `${sewn} of ${all} edges sewn, ${open} open`,
  finished: 'Every edge is sewn or stays open.',
  sure: (count: number) =>
    count === 1 ? 'One seam is as good as sure.' : `${count} seams are as good as sure.`,
  nothingSure: 'Nothing more to suggest.',
  isSewn: (one: string, other: string) => `Is ${one} sewn to ${other}?`,
  gathered: (share: string, length: string) =>
    `One side is ${share} longer (${length}). Gathered, so that the print need not match?`,
  orJoined: (side: string) => `Or is it ${side}?`,
  refusals: {
    sewn: 'That is sewn already; take it apart first.',
    nothing: 'Choose an edge first.',
    noCandidate: 'There is no match of that number.',
    finished: 'Every edge is sewn or stays open.',
  },
  /** Variants for touch input. */
  touch: {
    begin: 'Tap an edge that is sewn to another one.',
    best: (edge: string, length: string) =>
      `Best match: ${edge}, ${length}. Tap 1, or the edge that it is sewn to.`,
    bestWith: (more: string, edge: string, length: string) =>
      `Best match: with ${more} to ${edge}, ${length}. Tap 1, or the edge that it is sewn to.`,
    noMatch: 'Nothing is like it. Tap what it is sewn to, or Stays open.',
    held: 'Now tap what it is sewn to, or 1 to 5.',
    preview: (edge: string, ease: string) => `To ${edge}, ${ease}. Tap it to sew.`,
    sewnTo: (edge: string, ease: string) => `Sewn to ${edge}, ${ease}.`,
  },
  suggest: 'Suggest',
  acceptAll: (count: number) => `Accept all ${count}`,
  yes: 'Yes',
  no: 'No',
  skip: 'Skip',
  sewIt: 'Sew',
  turn: 'Turn',
  join: 'Join with the next edge',
  split: 'Split',
  open: 'Stays open',
  notOpen: 'Is sewn',
  unsew: 'Take apart',
  next: 'Next edge',
  actions: 'Sewing',
  candidates: 'What it may be sewn to',
  hold: 'Sew to …',
  keys: [
    ['Tab', 'Next edge, with Shift the one before'],
    ['Enter', 'Hold an edge, then sew it to the next one'],
    ['1 … 5', 'Sew to the match of that number'],
    ['Shift ← →', 'Several edges as one side, over seams as well; or click with Shift'],
    ['R', 'The other way round'],
    ['P', 'Split at the pointer, at a notch, or in the middle'],
    ['H', 'Stays open'],
    ['N', 'The longest edge that is not sewn'],
    ['Delete', 'Take the seam apart'],
    ['U', 'Undo'],
    ['M', 'Join the shorter side with its next edge, not gathered'],
    ['Q', 'Suggestions, answered by Y, N or S; A accepts all'],
  ] as readonly (readonly [key: string, meaning: string])[],
};

export type SewTexts = typeof sew;
