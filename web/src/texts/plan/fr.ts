/** En français : ce qui figure sur un plan de coupe. */
import type {PlanTexts} from '../../marker/draw/plan-texts.js';

export const plan: PlanTexts = {
  title: (scale) => `Plan de coupe 1 : ${scale}`,
  length: 'Longueur',
  proven: 'longueur minimale prouvée',
  atBest: (length) => `au mieux ${length}`,
  buy: 'Achetez',
  roundedUp: (step) => `arrondi par excès, à ${step} près`,
  use: 'Tissu utilisé',
  ofWidth: (width) => `sur une largeur de ${width}`,
  cost: 'L’imprimé coûte',
  without: (length) => `sans imprimé ${length}`,
  share: (share) => `${share} %`,
  cloth: (width, selvedge, gap, allowance) =>
    `Tissu de ${width} de large, lisières de ${selvedge}, ${gap} entre les pièces, marge de couture de ${allowance} ; simple épaisseur, endroit vers le haut.`,
  print: (name, across, along) =>
    `${name} : l’anneau est sur un coin du raccord, à ${across} du bord gauche, à ${along} du début.`,
  plain: 'Il n’est pas tenu compte de l’imprimé : les pièces sont posées n’importe où.',
  unplaced: (pieces) => `Sans place : ${pieces}.`,
  start: 'Début du tissu',
  page: (number, count) => `page ${number} sur ${count}`,
  garment: (piece, garment) => `${piece}, vêtement ${garment}`,
  crosses: 'Les croix d’une pièce sont sur un seul et même point de l’imprimé',
  crossesUnit: (unit) => `Chacune depuis le bord gauche × depuis le début du tissu [${unit}]`,
  number: 'Nº',
  piece: 'Pièce',
  cross: (number) => `Croix ${number}`,
  phases: 'L’imprimé peut commencer ailleurs au bord gauche',
  phase: 'Début de l’imprimé',
  widths: 'Sur d’autres largeurs',
  width: 'Largeur',
  none: '–',
};
