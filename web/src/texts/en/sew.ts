/** English texts of the sewing tool. */
import {text} from '../base/message.js';

export const sew = {
  begin: 'Choose an edge: click it, or press Tab. N selects the longest edge that is not sewn.',
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
    'No similar edge found. Press Enter and choose the edge to sew it to, or press H to leave it open. Shift ← → joins edges.',
  held: 'Now choose the edge to sew it to, or press 1 to 5. Shift ← → joins edges.',
  preview: text('Sew to {edge}, {ease}: press Enter.'),
  ease: text('ease {length}'),
  noEase: 'the same length',
  turned: 'Reversed.',
  sewnTo: text('Sewn to {edge}, {ease}. R reverses it, Delete unpicks it.'),
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
    'One side is {share} longer ({length}). Is it gathered, so the print need not match?',
  ),
  orJoined: text('Is it {side} instead?'),
  refusals: {
    sewn: 'This edge is sewn already; unpick the seam first.',
    nothing: 'Choose an edge first.',
    noCandidate: 'There is no match with that number.',
    finished: 'Every edge is sewn or stays open.',
  },
  /** Variants for touch input. */
  touch: {
    begin: 'Tap an edge to sew.',
    best: text('Best match: {edge}, {length}. Tap 1, or another edge to sew it to.'),
    bestWith: text(
      'Best match: with {more} to {edge}, {length}. Tap 1, or another edge to sew it to.',
    ),
    noMatch: 'No similar edge found. Tap the edge to sew it to, or Stays open.',
    held: 'Now tap the edge to sew it to, or 1 to 5.',
    preview: text('Sew to {edge}, {ease}: tap it.'),
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
  unsew: 'Unpick',
  next: 'Next edge',
  actions: 'Sewing',
  candidates: 'Edges to sew it to',
  hold: 'Sew to …',
  keys: [
    ['Tab', 'Next edge, with Shift the one before'],
    ['Enter', 'Hold an edge, then sew it to the next one'],
    ['1 … 5', 'Sew to the match with that number'],
    ['Shift ← →', 'Several edges as one side, also across seams; or Shift-click'],
    ['R', 'Reverse the direction'],
    ['P', 'Split at the pointer, at a notch, or in the middle'],
    ['H', 'Stays open'],
    ['N', 'The longest edge that is not sewn'],
    ['Delete', 'Unpick the seam'],
    ['U', 'Undo'],
    ['M', 'Join the shorter side with its next edge, not gathered'],
    [
      'Q',
      'Questions about seams, answered by Y, N or L (later); B takes the last answer back, A accepts all certain ones',
    ],
  ] as readonly (readonly [key: string, meaning: string])[],
};

export type SewTexts = typeof sew;
