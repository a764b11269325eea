/** English texts of the photo dialog. */
import {text} from '../base/message.js';
import type {PhotoFault} from '../../model/base/failure.js';
import type {
  KnownObject,
  PhotoNote,
  PhotoStage,
  SymmetryVerdict,
} from '../../model/print/photo-reading.js';

export const photo = {
  title: 'Photo of your fabric',
  intake:
    'Spread the fabric flat and photograph it from above, with at least three repeats in both directions. Choose the picture, drop it here, or paste it.',
  good: 'Flat and from above, with many repeats and even light.',
  bad: 'From the side, with folds and a shadow.',
  stays: 'It stays on this device.',
  choose: 'Choose a picture',
  camera: 'Take a photo',
  another: 'Another picture',
  photo: 'Photo of the fabric',
  corner: 'Corner of the repeat',
  end: text('End of the arrow: {way}'),
  ends: ['First measured point', 'Second measured point'] as readonly string[],
  stages: {
    repeat: 'Looking for the repeat',
    light: 'Evening out the light',
    symmetry: 'Comparing symmetries',
    tile: 'Making one clean repeat',
    object: 'Looking for the outline',
  } satisfies Record<PhotoStage, string> as Record<PhotoStage, string>,
  faults: {
    plain:
      'No print was found: the fabric looks plain. Photograph it in brighter light from one side.',
    noRepeat:
      'No repeat was found: step back until at least three repeats are visible each way, and photograph the fabric flat, from above.',
    fewRepeats: 'Too few repeats are visible: step back until there are three each way.',
    twoPrints:
      'A part of the picture shows another print, or none: crop the picture to the print you want.',
    changes:
      'The print changes along the fabric: photograph a part in which all repeats are alike.',
    blurred: 'The picture is blurred: hold the camera still, and let it focus on the fabric.',
    moire: 'The weave makes wavy lines (moiré) in the picture: go a little closer or farther away.',
    uneven: 'The fabric does not lie flat: smooth it out and photograph it again.',
    misplaced:
      'The print does not repeat like this: put the corners on the same spot of neighbouring motifs, or undo.',
    edges: 'The picture’s edges do not meet: use the whole repeat, or a photo of several repeats.',
    small: 'The picture is too small: use one of at least 32 pixels each way.',
    object:
      'The object was not found there: tap its middle, or measure between two points instead.',
  } satisfies Record<PhotoFault, string> as Record<PhotoFault, string>,
  reading: text('{stage}, {percent}'),
  cancelled: 'Stopped.',
  again: 'Look again',
  byHand: 'Draw the repeat by hand',
  hand: 'Drag the corner and both arrows onto one repeat of the print, then:',
  alignHand: 'Find the repeat from here',
  found: text('Found: {group}.'),
  confidences: {
    likely: 'This is likely. Compare the swatch with your fabric.',
    uncertain:
      'No repeat is certain: choose the right one, move the corners, or take another photo with three repeats in both directions.',
  },
  others: 'Other choices',
  other: text('Repeat {number, number}'),
  notes: {
    uneven: 'The fabric does not lie quite flat.',
    differs: 'Red areas differ from all other copies, and are left out.',
    focalLength:
      'Measure both across and up: with one of them alone, the proportions are uncertain.',
    unequal: 'The measured sides differ, so mirrors and turns that need equal sides are left out.',
  } satisfies Record<PhotoNote, string> as Record<PhotoNote, string>,
  lattice: 'Repeat',
  how: 'Drag corners, or move them with the arrow keys: the repeat follows the print near them. With Alt it stays as you place it.',
  ways: {across: 'across', up: 'up'},
  twice: text('Twice as long: {way}'),
  half: text('Half as long: {way}'),
  halfDrop: 'Half-drop',
  group: 'Symmetry',
  verdicts: {
    has: 'has',
    almost: 'almost',
    'has not': 'has not',
    cannot: 'impossible with this repeat',
  } satisfies Record<SymmetryVerdict, string> as Record<SymmetryVerdict, string>,
  foundOne: 'found',
  breaks: text('Differences from “{group}”'),
  exact: 'Make the repeat perfectly symmetric',
  show: 'Show',
  overlays: {
    cells: 'Repeats',
    axes: 'Mirrors and turns',
    differing: 'Copies that differ',
    breaks: 'Differences from the symmetry',
  },
  flatten: 'Flatten the light',
  white: 'White balance',
  tapWhite:
    'Tap something white on the photo. Or move the ring with the arrow keys and press Enter.',
  aimWhite: 'Something white',
  asTaken: 'Colours as taken',
  swatch: 'Swatch, 3 repeats wide',
  making: 'Making the swatch …',
  size: 'Size',
  unknown:
    'Size unknown: measure it in one of these ways. Without it you can match the print, but not cut the pattern.',
  repeatsAlong: text('Repeats {way}'),
  repeatsAcross: 'Repeats across the stripes',
  measure: text('measure ({unit})'),
  measureBy: 'Measure by',
  measuring: {tape: 'Tape', points: 'Two points', object: 'Coin or card'},
  between: 'Drag the two points on the photo, then enter the distance between them.',
  object: 'Object',
  objects: {
    eur1: '1 euro, 23.25 mm',
    eur2: '2 euros, 25.75 mm',
    quarter: 'US quarter, 24.26 mm',
    gbp1: '1 pound, 23.4 mm',
    card: 'Card, 85.60 × 53.98 mm',
    a4: 'A4 sheet, 297 × 210 mm',
  } satisfies Record<KnownObject, string> as Record<KnownObject, string>,
  aim: 'Middle of the coin or card',
  tap: 'It has to be flat on the fabric. Tap its middle on the photo, or move the ring with the arrow keys and press Enter.',
  look: 'Look for it at the ring',
  byObject: text('Measured by the red outline, accurate to about {error}.'),
  distance: text('Distance between them ({unit})'),
  measures: text('One repeat is {width} × {height}.'),
  oneMeasure: text('One repeat is {width}, measured across the stripes.'),
  vectors: text('Its arrows are {w1} and {w2} long.'),
  sidesApart: text(
    'Your measures disagree by {share}: one repeat is {w1} one way, but {w2} the other, and its symmetry needs equal sides. {w1} counts until you remove one, or choose another symmetry.',
    'w1',
    'w2',
    'share',
  ),
  photoApart: text(
    'Your measures disagree by {share}: with {w1} one way, the photo shows {expected} the other, not {w2}. Both count until you remove one.',
    'w1',
    'w2',
    'share',
    'expected',
  ),
  removeMeasure: 'Remove this measure',
  objectOnFabric: 'Object on the fabric',
  turn: 'Turn by 90°',
  warp: text('The print is turned by {turn}; the length of the fabric runs upwards.'),
  name: 'Name',
  use: 'Use this print',
  useDoubtful: 'Use it anyway',
  doubt:
    'It is uncertain that this is the print’s repeat: drag its corners into place, or choose another.',
};

export type PhotoTexts = typeof photo;
