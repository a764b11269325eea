/** Italian texts of a drawn layout. */
import type {PlanTexts} from '../../marker/draw/plan-texts.js';

export const plan: PlanTexts = {
  title: (scale) => `Piano di taglio 1 : ${scale}`,
  length: 'Lunghezza',
  proven: 'lunghezza minima dimostrata',
  atBest: (length) => `nel caso migliore ${length}`,
  lying: 'dei pezzi disposti',
  buy: 'Compra',
  roundedUp: (step) => `arrotondato in su, a passi di ${step}`,
  use: 'Tessuto usato',
  ofWidth: (width) => `su un’altezza di ${width}`,
  cost: 'La stampa costa',
  without: (length) => `senza stampa ${length}`,
  share: (share) => `${share} %`,
  cloth: (width, selvedge, gap, allowance) =>
    `Tessuto alto ${width}, cimose di ${selvedge}, ${gap} tra i pezzi, margine di cucitura di ${allowance}; un solo strato, con il dritto verso l’alto.`,
  folded: (width, selvedge, gap, allowance, fold) =>
    `Tessuto alto ${width}, cimose di ${selvedge}, ${gap} tra i pezzi, margine di cucitura di ${allowance}; piegato per il lungo a ${fold} dal bordo sinistro, dritto contro dritto, mostrato aperto.`,
  print: (name, across, along) =>
    `${name}: l’anello è su un angolo del rapporto, a ${across} dal bordo sinistro, a ${along} dall’inizio.`,
  plain: 'La stampa non è considerata: i pezzi stanno ovunque.',
  unplaced: (pieces) => `Senza posto: ${pieces}.`,
  pinned: (length) => `I pezzi fissati costano ${length} in più.`,
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
  notes: {
    plainPieces: ({pieces}) =>
      `I pezzi di tessuto in tinta unita non si dispongono sulla stampa: ${pieces}.`,
    pliesUnlike: () =>
      'Questa stampa non si ripete mai lungo il tessuto, quindi con nessuna lunghezza tutti gli strati iniziano allo stesso modo: disponili uno alla volta.',
    pliesWhole: ({counts: [plies], lengths: [repeat]}) =>
      `Ciascuno dei ${plies} strati è lungo un numero intero di rapporti di ${repeat}, perché tutti inizino allo stesso modo.`,
    flawsFromCut: () =>
      'I difetti si contano dal taglio, dove si suppone che inizi la stampa; altrimenti indica a che distanza inizia.',
    folded: ({rounded: [edge]}) =>
      `Il tessuto è piegato a ${edge} dal bordo sinistro, dritto contro dritto, e i due strati si tagliano insieme.`,
    foldKeepsPrint: () =>
      'Sul tessuto piegato la stampa non si sposta sotto nessun pezzo, perché lo strato inferiore ne mostra l’immagine speculare.',
    phaseRange: ({range: [least, most]}) =>
      `Da ${least} a ${most}, secondo dove inizia la stampa alla cimosa; misuralo.`,
    phaseNowhere: ({counts: [nowhere, all]}) =>
      `In ${nowhere} di ${all} possibili inizi della stampa non ci stanno tutti i pezzi sul tessuto.`,
  },
};
