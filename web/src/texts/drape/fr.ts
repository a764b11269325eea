/** French texts of the drape. */
import type {WornTexts} from './en.js';

export const worn: WornTexts = {
  label: 'Vêtement porté',
  description:
    'Les flèches tournent le vêtement, avec Maj elles le déplacent, plus et moins zooment ; 1 à 5 le montrent de face, de dos, de gauche, de droite et de trois quarts, 0 en entier.',
  fabric: 'Étoffe',
  fabrics: {
    poplin: 'Popeline',
    jersey: 'Maille jersey',
    denim: 'Toile denim',
    chiffon: 'Mousseline',
  },
  form: 'Mannequin',
  seams: 'Coutures',
  turntable: 'Plateau tournant',
  look: 'Vu de',
  looks: {
    front: 'Face',
    back: 'Dos',
    left: 'Gauche',
    right: 'Droite',
    'three-quarter': 'Trois quarts',
  },
  seen: {
    front: 'Vue de face.',
    back: 'Vue de dos.',
    left: 'Vue de gauche.',
    right: 'Vue de droite.',
    'three-quarter': 'Vue de trois quarts.',
  },
  worst: (seams, most, seam) => `${seams} ; au pire ${most} : ${seam}.`,
  draping: (percent) => `Drapé en cours, ${percent}`,
  stop: 'Arrêter',
  stopped: 'Arrêté : le vêtement n’a pas fini de tomber.',
  again: 'Draper à nouveau',
  waiting: 'Drapé dès que l’imprimé est aligné',
  truth: 'Un drapé, pas une promesse de coupe',
  nextPiece: 'Pièce suivante',
  pieceBefore: 'Pièce précédente',
  savePicture: 'Enregistrer une image du vêtement',
  saveModel: 'Enregistrer le modèle 3D (GLB)',
  saveFilm: 'Enregistrer le film d’un tour',
  filming: 'Enregistrement d’un tour, 8 secondes…',
};
