/** English texts of the tool for folds. */
import {text} from '../base/message.js';

export const fold = {
  begin: {
    pleat:
      'Click the place of the first fold line: on an edge, or on a line of the piece. Click a fold to change it.',
    crease: 'Click one end of the crease, or a line of the piece. Click a fold to change it.',
  },
  next: {
    pleat: 'Now click the place of the second line. The first line is laid on it.',
    crease: 'Now click the other end of the crease.',
  },
  /** The line under the pointer, once the first one is set. */
  between: text('{length} of fabric between the lines'),
  chosen: text('{kind} on {piece}, {length} of fabric.'),
  chosenCrease: text('{kind} on {piece}.'),
  edit: 'Change it below, or click the place of a new fold line.',
  cursor: text(
    'Place on {piece}: ← → move it, with Shift by 1 mm; ↑ ↓ go to the next corner or middle of an edge. Enter sets it.',
  ),
  refusals: {
    otherPiece: 'Both lines have to be on the same piece.',
    near: 'The two places are too close together.',
    outside: 'There is no room for a fold line at this place.',
    crossing: 'The two lines cross. Choose places beside each other.',
    overlaps: 'There is a pleat at this place already. Choose another place, or remove that pleat.',
  },
  bar: 'Fold',
  kind: 'Kind',
  kinds: {
    knife: 'Knife pleat',
    box: 'Box pleat',
    inverted: 'Inverted pleat',
    tuck: 'Tuck',
    roll: 'Roll line',
    press: 'Press line',
  },
  fabric: text('Fabric in it, {unit}'),
  length: text('Length, {unit}'),
  reverse: 'Reverse',
  mirrored: 'Mirrored, too',
  nextFold: 'Next fold',
  remove: 'Remove',
  count: text('{count, plural, =0 {No folds yet} one {# fold} other {# folds}}'),
  keys: [
    ['Enter', 'Shows a place on the selected piece, then sets it'],
    ['←  →', 'Move the place by 1 cm, with Shift by 1 mm'],
    ['↑  ↓', 'To the next corner or middle of an edge'],
    ['1 … 6', 'Knife, box, inverted pleat, tuck, roll line, press line'],
    ['Tab', 'Next fold, with Shift the one before'],
    ['R', 'Reverses the selected fold'],
    ['Delete', 'Removes the selected fold'],
  ] as readonly (readonly [key: string, meaning: string])[],
  /** Variants for touch input. */
  touch: {
    begin: {
      pleat:
        'Tap the place of the first fold line: on an edge, or on a line of the piece. Tap a fold to change it.',
      crease: 'Tap one end of the crease, or a line of the piece. Tap a fold to change it.',
    },
    next: {
      pleat: 'Now tap the place of the second line. The first line is laid on it.',
      crease: 'Now tap the other end of the crease.',
    },
    edit: 'Change it below, or tap the place of a new fold line.',
  },
};

export type FoldTexts = typeof fold;
