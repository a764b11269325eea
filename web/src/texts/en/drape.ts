/** English texts of the drape. */
import {text} from '../base/message.js';

export const worn = {
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
  stopped: 'Stopped: the garment has not settled.',
  again: 'Drape again',
  waiting: 'Draped once the print is aligned',
  truth: 'A drape, no promise of fit',
  nextPiece: 'Next piece',
  pieceBefore: 'Piece before',
  savePicture: 'Save picture of the garment',
  saveModel: 'Save 3D model (GLB)',
  saveFilm: 'Save film of a turn',
  filming: 'Recording a turn, 8 seconds …',
};

export type DrapeTexts = typeof worn;
