/** German texts of the drape. */
import type {WornTexts} from './en.js';

export const worn: WornTexts = {
  label: 'Kleidungsstück, getragen',
  description:
    'Pfeiltasten drehen das Kleidungsstück, mit Umschalt verschieben sie es, Plus und Minus zoomen; 1 bis 5 zeigen es von vorn, hinten, links, rechts und schräg, 0 zeigt alles.',
  fabric: 'Stoff',
  fabrics: {poplin: 'Popeline', jersey: 'Jersey', denim: 'Jeansstoff', chiffon: 'Chiffon'},
  form: 'Büste',
  seams: 'Nähte',
  turntable: 'Drehteller',
  look: 'Gesehen von',
  looks: {
    front: 'Vorn',
    back: 'Hinten',
    left: 'Links',
    right: 'Rechts',
    'three-quarter': 'Schräg vorn',
  },
  seen: {
    front: 'Ansicht von vorn.',
    back: 'Ansicht von hinten.',
    left: 'Ansicht von links.',
    right: 'Ansicht von rechts.',
    'three-quarter': 'Ansicht von schräg vorn.',
  },
  worst: (seams, most, seam) => `${seams}; am schlechtesten ${most}: ${seam}.`,
  draping: (percent) => `Wird drapiert, ${percent}`,
  stop: 'Anhalten',
  stopped: 'Angehalten: Das Kleidungsstück hängt noch nicht ruhig.',
  again: 'Neu drapieren',
  waiting: 'Wird drapiert, sobald der Druck angepasst ist',
  truth: 'Ein Faltenwurf, keine Zusage zur Passform',
  nextPiece: 'Nächstes Teil',
  pieceBefore: 'Vorheriges Teil',
  savePicture: 'Bild des Kleidungsstücks speichern',
  saveModel: '3D-Modell speichern (GLB)',
  saveFilm: 'Film einer Umdrehung speichern',
  filming: 'Eine Umdrehung wird aufgenommen, 8 Sekunden …',
};
