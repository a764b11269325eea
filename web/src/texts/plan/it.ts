/** In italiano: ciò che sta su un piano di taglio. */
import type {PlanTexts} from '../../marker/draw/plan-texts.js';

export const plan: PlanTexts = {
  title: (scale) => `Piano di taglio 1 : ${scale}`,
  length: 'Lunghezza',
  proven: 'lunghezza minima dimostrata',
  atBest: (length) => `nel caso migliore ${length}`,
  buy: 'Compra',
  roundedUp: (step) => `arrotondato in su, a passi di ${step}`,
  use: 'Tessuto usato',
  ofWidth: (width) => `su un’altezza di ${width}`,
  cost: 'La stampa costa',
  without: (length) => `senza stampa ${length}`,
  share: (share) => `${share} %`,
  cloth: (width, selvedge, gap, allowance) =>
    `Tessuto alto ${width}, cimose di ${selvedge}, ${gap} tra i pezzi, margine di cucitura di ${allowance}; un solo strato, con il dritto verso l’alto.`,
  print: (name, across, along) =>
    `${name}: l’anello è su un angolo del rapporto, a ${across} dal bordo sinistro, a ${along} dall’inizio.`,
  plain: 'La stampa non è considerata: i pezzi stanno ovunque.',
  unplaced: (pieces) => `Senza posto: ${pieces}.`,
  start: 'Inizio del tessuto',
  page: (number, count) => `pagina ${number} di ${count}`,
  garment: (piece, garment) => `${piece}, capo ${garment}`,
  crosses: 'Le croci di un pezzo stanno su uno stesso punto della stampa',
  crossesUnit: (unit) => `Ciascuna dal bordo sinistro × dall’inizio del tessuto [${unit}]`,
  number: 'N.',
  piece: 'Pezzo',
  cross: (number) => `Croce ${number}`,
  phases: 'La stampa può iniziare altrove al bordo sinistro',
  phase: 'Inizio della stampa',
  widths: 'Su altre altezze',
  width: 'Altezza',
  none: '–',
};
