/** Italian texts of the drape. */
import type {WornTexts} from './en.js';

export const worn: WornTexts = {
  label: 'Capo indossato',
  description:
    'Le frecce girano il capo, con Maiusc lo spostano, più e meno ingrandiscono e riducono; da 1 a 5 lo mostrano davanti, dietro, da sinistra, da destra e di tre quarti, 0 per intero.',
  fabric: 'Stoffa',
  fabrics: {poplin: 'Popeline di cotone', jersey: 'Maglina', denim: 'Tela jeans', chiffon: 'Velo'},
  form: 'Manichino',
  seams: 'Cuciture',
  turntable: 'Piatto girevole',
  look: 'Visto da',
  looks: {
    front: 'Davanti',
    back: 'Dietro',
    left: 'Sinistra',
    right: 'Destra',
    'three-quarter': 'Tre quarti',
  },
  seen: {
    front: 'Vista davanti.',
    back: 'Vista dietro.',
    left: 'Vista da sinistra.',
    right: 'Vista da destra.',
    'three-quarter': 'Vista di tre quarti.',
  },
  worst: (seams, most, seam) => `${seams}; la peggiore ${most}: ${seam}.`,
  draping: (percent) => `Drappeggio, ${percent}`,
  stop: 'Ferma',
  stopped: 'Fermato: il capo non ha finito di cadere.',
  again: 'Drappeggia di nuovo',
  waiting: 'Drappeggiato appena la stampa è allineata',
  truth: 'Un drappeggio, nessuna promessa di vestibilità',
  nextPiece: 'Pezzo successivo',
  pieceBefore: 'Pezzo precedente',
  savePicture: 'Salva un’immagine del capo',
  saveModel: 'Salva il modello 3D (GLB)',
  saveFilm: 'Salva il video di un giro',
  filming: 'Registrazione di un giro, 8 secondi…',
};
