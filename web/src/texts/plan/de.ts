/** German texts of a drawn layout. */
import type {PlanTexts} from '../../marker/draw/plan-texts.js';

export const plan: PlanTexts = {
  title: (scale) => `Legeplan 1 : ${scale}`,
  length: 'Länge',
  proven: 'nachweislich am kürzesten',
  atBest: (length) => `bestenfalls ${length}`,
  lying: 'der Teile, die liegen',
  buy: 'Kaufen',
  roundedUp: (step) => `aufgerundet auf volle ${step}`,
  use: 'Stoff genutzt',
  ofWidth: (width) => `von ${width} Breite`,
  cost: 'Das Muster kostet',
  without: (length) => `ohne Muster ${length}`,
  share: (share) => `${share} %`,
  cloth: (width, selvedge, gap, allowance) =>
    `Stoff ${width} breit, Webkanten ${selvedge}, ${gap} zwischen den Teilen, Nahtzugabe ${allowance}; einlagig, rechte Seite oben.`,
  folded: (width, selvedge, gap, allowance, fold) =>
    `Stoff ${width} breit, Webkanten ${selvedge}, ${gap} zwischen den Teilen, Nahtzugabe ${allowance}; ${fold} vom linken Rand längs gefaltet, rechts auf rechts, aufgeklappt gezeigt.`,
  print: (name, across, along) =>
    `${name}: der Ring liegt auf einer Ecke des Rapports, ${across} vom linken Rand, ${along} vom Anfang.`,
  plain: 'Das Muster wird nicht beachtet: die Teile liegen beliebig.',
  unplaced: (pieces) => `Ohne Platz: ${pieces}.`,
  pinned: (length) => `Angeheftete Teile kosten ${length} mehr.`,
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
  notes: {
    plainPieces: ({pieces}) =>
      `Teile aus einfarbigem Stoff liegen nicht auf dem Muster: ${pieces}.`,
    pliesUnlike: () =>
      'Das Muster wiederholt sich nie längs des Stoffs, also beginnen die Lagen bei keiner Länge gleich: bitte einzeln legen.',
    pliesWhole: ({counts: [plies], lengths: [repeat]}) =>
      `Jede der ${plies} Lagen ist ganze Rapporte von ${repeat} lang, damit alle gleich beginnen.`,
    flawsFromCut: () =>
      'Fehler zählen vom Anfang des Stoffs, wo auch das Muster beginnen soll; beginnt es woanders, bitte angeben, wie weit davon.',
    folded: ({rounded: [edge]}) =>
      `Der Stoff ist ${edge} vom linken Rand gefaltet, rechts auf rechts, und beide Lagen werden zugleich geschnitten.`,
    foldKeepsPrint: () =>
      'Auf gefaltetem Stoff wird das Muster unter keinem Teil verschoben, denn die untere Lage zeigt sein Spiegelbild.',
    phaseRange: ({range: [least, most]}) =>
      `${least} bis ${most}, je nachdem, wo das Muster an der Webkante beginnt; bitte messen.`,
    phaseNowhere: ({counts: [nowhere, all]}) =>
      `An ${nowhere} von ${all} möglichen Stellen des Musterbeginns passen nicht alle Teile auf den Stoff.`,
  },
};
