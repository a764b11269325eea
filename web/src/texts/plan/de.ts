/** Auf Deutsch: was auf einem Legeplan steht. */
import type {PlanTexts} from '../../marker/draw/plan-texts.js';

export const plan: PlanTexts = {
  title: (scale) => `Legeplan 1 : ${scale}`,
  length: 'Länge',
  proven: 'nachweislich am kürzesten',
  atBest: (length) => `bestenfalls ${length}`,
  buy: 'Kaufen',
  roundedUp: (step) => `aufgerundet auf volle ${step}`,
  use: 'Stoff genutzt',
  ofWidth: (width) => `von ${width} Breite`,
  cost: 'Das Muster kostet',
  without: (length) => `ohne Muster ${length}`,
  share: (share) => `${share} %`,
  cloth: (width, selvedge, gap, allowance) =>
    `Stoff ${width} breit, Webkanten ${selvedge}, ${gap} zwischen den Teilen, Nahtzugabe ${allowance}; einlagig, rechte Seite oben.`,
  print: (name, across, along) =>
    `${name}: der Ring liegt auf einer Ecke des Rapports, ${across} vom linken Rand, ${along} vom Anfang.`,
  plain: 'Das Muster wird nicht beachtet: die Teile liegen beliebig.',
  unplaced: (pieces) => `Ohne Platz: ${pieces}.`,
  start: 'Anfang des Stoffs',
  page: (number, count) => `Seite ${number} von ${count}`,
  garment: (piece, garment) => `${piece}, Kleidungsstück ${garment}`,
  crosses: 'Die Kreuze eines Teils liegen auf ein und demselben Punkt des Musters',
  crossesUnit: (unit) => `Jedes vom linken Rand × vom Anfang des Stoffs [${unit}]`,
  number: 'Nr.',
  piece: 'Teil',
  cross: (number) => `Kreuz ${number}`,
  phases: 'Das Muster kann am linken Rand woanders beginnen',
  phase: 'Musterbeginn',
  widths: 'Auf anderen Breiten',
  width: 'Breite',
  none: '–',
};
