/** English texts of the sewing tool. */
import {text} from '../base/message.js';

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
  edge: text('{place} of {piece}'),
  run: text('{count, number} edges from {first}'),
  both: text('{one} with {other}'),
  chosen: text('{edge}, {length}.'),
  best: text('Best match: {edge}, {length}. Press 1 to sew.'),
  bestWith: text('Best match: with {more} to {edge}, {length}. Press 1 to sew.'),
  noMatch:
    'Nothing is like it. Press Enter and choose what it is sewn to, or H: it stays open. Shift ← → joins edges.',
  held: 'Now choose what it is sewn to, or press 1 to 5. Shift ← → joins edges.',
  preview: text('To {edge}, {ease}. Press Enter to sew.'),
  ease: text('ease {length}'),
  noEase: 'the same length',
  turned: 'The other way round.',
  sewnTo: text('Sewn to {edge}, {ease}. R turns it, Delete takes it apart.'),
  staysOpen: 'Stays open.',
  count: text('{sewn, number} of {all, number} edges sewn, {open, number} open'),
  finished: 'Every edge is sewn or stays open.',
  sure: text(
    '{count, plural, =1 {One seam is almost certain.} other {# seams are almost certain.}}',
  ),
  nothingSure: 'No further seam is likely. Click an edge to sew it yourself; the rest stays open.',
  isSewn: text('Is {one} sewn to {other}?'),
  /** A question about a whole seam: `place` begins the sentence, such as "Side seams". */
  asks: text('{place}: sew {one} to {other}?'),
  /** The same of two edges of one piece. */
  asksItself: text('{place}: sew {piece} to itself?'),
  /** The same without a name of the place. */
  asksPieces: text('Sew {one} to {other}?'),
  gathered: text(
    'One side is {share} longer ({length}). Gathered, so that the print need not match?',
  ),
  orJoined: text('Or is it {side}?'),
  refusals: {
    sewn: 'This edge is sewn already; take it apart first.',
    nothing: 'Choose an edge first.',
    noCandidate: 'There is no match of that number.',
    finished: 'Every edge is sewn or stays open.',
  },
  /** Variants for touch input. */
  touch: {
    begin: 'Tap an edge that is sewn to another one.',
    best: text('Best match: {edge}, {length}. Tap 1, or the edge that it is sewn to.'),
    bestWith: text(
      'Best match: with {more} to {edge}, {length}. Tap 1, or the edge that it is sewn to.',
    ),
    noMatch: 'Nothing is like it. Tap what it is sewn to, or Stays open.',
    held: 'Now tap what it is sewn to, or 1 to 5.',
    preview: text('To {edge}, {ease}. Tap it to sew.'),
    sewnTo: text('Sewn to {edge}, {ease}.'),
  },
  suggest: 'Suggest seams',
  acceptAll: text('Accept all {count, number}'),
  yes: 'Yes',
  no: 'No',
  skip: 'Later',
  back: 'Back',
  /** Number of the present question, and of all. */
  progress: text('{present, number} of {all, number}'),
  picture: 'Both sides of the seam, as sewn',
  sewIt: 'Sew',
  turn: 'Turn',
  join: 'Join with the next edge',
  split: 'Split',
  open: 'Stays open',
  notOpen: 'Is sewn',
  unsew: 'Take apart',
  next: 'Next edge',
  actions: 'Sewing',
  candidates: 'Edges that may be sewn to it',
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
    [
      'Q',
      'Questions about seams, answered by Y, N or L (later); B takes the last answer back, A accepts all certain ones',
    ],
  ] as readonly (readonly [key: string, meaning: string])[],
};

export type SewTexts = typeof sew;
