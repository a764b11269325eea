/** French texts of a drawn layout. */
import type {PlanTexts} from '../../marker/draw/plan-texts.js';

export const plan: PlanTexts = {
  title: (scale) => `Plan de coupe 1 : ${scale}`,
  length: 'Longueur',
  proven: 'longueur minimale prouvée',
  atBest: (length) => `au mieux ${length}`,
  lying: 'des pièces placées',
  buy: 'Achetez',
  roundedUp: (step) => `arrondi par excès, à ${step} près`,
  use: 'Tissu utilisé',
  ofWidth: (width) => `sur une largeur de ${width}`,
  cost: 'L’imprimé coûte',
  without: (length) => `sans imprimé ${length}`,
  share: (share) => `${share} %`,
  cloth: (width, selvedge, gap, allowance) =>
    `Tissu de ${width} de large, lisières de ${selvedge}, ${gap} entre les pièces, marge de couture de ${allowance} ; simple épaisseur, endroit vers le haut.`,
  folded: (width, selvedge, gap, allowance, fold) =>
    `Tissu de ${width} de large, lisières de ${selvedge}, ${gap} entre les pièces, marge de couture de ${allowance} ; plié dans la longueur à ${fold} du bord gauche, endroit contre endroit, montré déplié.`,
  print: (name, across, along) =>
    `${name} : l’anneau est sur un coin du raccord, à ${across} du bord gauche, à ${along} du début.`,
  plain: 'Il n’est pas tenu compte de l’imprimé : les pièces sont posées n’importe où.',
  unplaced: (pieces) => `Sans place : ${pieces}.`,
  pinned: (length) => `Les pièces épinglées coûtent ${length} de plus.`,
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
  notes: {
    plainPieces: ({pieces}) =>
      `Les pièces en tissu uni ne sont pas placées sur l’imprimé : ${pieces}.`,
    pliesUnlike: () =>
      'Cet imprimé ne se répète jamais dans la longueur, aucune longueur ne fait donc commencer tous les plis de la même façon : placez-les un par un.',
    pliesWhole: ({counts: [plies], lengths: [repeat]}) =>
      `Chacune des ${plies} épaisseurs mesure un nombre entier de raccords de ${repeat}, pour que toutes commencent de la même façon.`,
    flawsFromCut: () =>
      'Les défauts se comptent depuis la coupe, où l’imprimé est censé commencer ; sinon, indiquez à quelle distance il commence.',
    folded: ({rounded: [edge]}) =>
      `Le tissu est plié à ${edge} du bord gauche, endroit contre endroit, et les deux épaisseurs sont coupées ensemble.`,
    foldKeepsPrint: () =>
      'Sur tissu plié, l’imprimé n’est décalé sous aucune pièce, car l’épaisseur du dessous en montre l’image en miroir.',
    phaseRange: ({range: [least, most]}) =>
      `De ${least} à ${most}, selon où l’imprimé commence à la lisière ; mesurez-le.`,
    phaseNowhere: ({counts: [nowhere, all]}) =>
      `Pour ${nowhere} des ${all} débuts possibles de l’imprimé, toutes les pièces ne tiennent pas sur le tissu.`,
  },
};
