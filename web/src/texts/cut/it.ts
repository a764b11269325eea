/** Italian texts of the cutting dialog. */
import {cloth} from '../marker/it.js';
import type {CutTexts} from './en.js';

export const cutting: CutTexts = {
  title: 'Taglio',
  file: 'File da salvare',
  files: {pdf: 'PDF', svg: 'SVG', dxf: 'DXF', plt: 'HP-GL'},
  fileNotes: {
    pdf: 'Pagine a grandezza naturale da stampare, incollare o proiettare, con livelli.',
    svg: 'Un solo foglio, per tipografie e taglio laser.',
    dxf: 'Un blocco per pezzo, per programmi CAD e tavoli da taglio (AAMA).',
    plt: 'Un foglio di linee, per plotter.',
  },
  paper: 'Carta',
  roll: 'Rotolo, 36 pollici',
  projector: 'Proiettore',
  allowance: cloth.allowance,
  hem: cloth.hem,
  toSize: cloth.toSize,
  print: 'Disegnare la stampa sui pezzi',
  map: 'Come stanno le pagine',
  sheetMap: 'Come stanno i pezzi',
  pages: (count) => (count === 1 ? '1 pagina' : `${count} pagine`),
  each: (paper, size) => `${paper}, ${size}`,
  sheet: (size) => `Foglio ${size}`,
  extent: (width, height) => `${width} × ${height}`,
  ownAllowances: cloth.ownAllowances,
  waiting: 'La stampa è ancora in corso di allineamento…',
  unsolved: 'Non c’è ancora nulla da tagliare: allinea prima la stampa.',
  renewed: 'Il risultato è cambiato: questo è quello nuovo.',
  planning: 'Disposizione dei pezzi …',
  making: 'Creazione del file …',
  atFullSize: 'Stampa al 100 %, poi misura i quadrati della prima pagina.',
  save: (file) => `Salva ${file}`,
  failed: (message) => `Il file non è stato creato. In inglese: ${message}`,
};
