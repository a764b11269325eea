/** English texts of the drape. */
import {text} from '../base/message.js';

export const drape = {
  label: 'Garment, worn',
  description:
    'Arrow keys turn the garment, with Shift they move it, plus and minus zoom; 1 to 5 show it from the front, the back, the left, the right and at an angle, 0 all of it.',
  fabric: 'Fabric',
  fabrics: {poplin: 'Poplin', jersey: 'Jersey', denim: 'Denim', chiffon: 'Chiffon'},
  form: 'Form',
  seams: 'Seams',
  turntable: 'Turntable',
  look: 'Seen from',
  looks: {
    front: 'Front',
    back: 'Back',
    left: 'Left',
    right: 'Right',
    'three-quarter': 'Three-quarter',
  },
  seen: {
    front: 'Front view.',
    back: 'Back view.',
    left: 'View from the left.',
    right: 'View from the right.',
    'three-quarter': 'Three-quarter view.',
  },
  draping: text('Draping, {percent}'),
  stop: 'Stop',
  stopped: 'Stopped: the garment still moves.',
  again: 'Drape again',
  strained: text('{fabric} would stretch too far on this form.'),
  tooTight: text('The garment is {length} too tight {place} for this form.'),
  /** Places of the body, by the core's names. */
  at: {
    bust: 'at the bust',
    waist: 'at the waist',
    hip: 'at the hip',
    'upper arm': 'at the upper arm',
    wrist: 'at the wrist',
    thigh: 'at the thigh',
    knee: 'at the knee',
    ankle: 'at the ankle',
  },
  drapeIn: text('Drape it in {fabric}'),
  drapeOn: text('Drape it on a form of size {size}'),
  waiting: 'The drape starts once the print is matched',
  /** Notes on a drape, by code. */
  notes: {
    drapeNoStart:
      'The garment cannot be shown worn: it is unknown where its pieces are on the body.',
    drapeMoving: text('The garment is not quite at rest yet; it still moves by {length}.'),
    drapeCrossings: text(
      '{count, plural, one {The fabric passes through itself at # place.} other {The fabric passes through itself at # places.}}',
    ),
    drapeBySeams: 'The file has no positions of the pieces, so they hang by their seams and names.',
  },
  truth: 'A drape does not show how the garment fits',
  nextPiece: 'Next piece',
  pieceBefore: 'Piece before',
  savePicture: 'Save picture of the garment',
  saveModel: 'Save 3D model (GLB)',
  saveFilm: 'Save film of a turn',
  filming: 'Recording a turn, 8 seconds …',
};

export type DrapeTexts = typeof drape;
