/** Spanish texts of the drape. */
import type {WornTexts} from './en.js';

export const worn: WornTexts = {
  label: 'Prenda puesta',
  description:
    'Las flechas giran la prenda, con Mayús la desplazan, más y menos acercan y alejan; 1 a 5 la muestran de frente, de espaldas, desde la izquierda, desde la derecha y en tres cuartos, 0 entera.',
  fabric: 'Tela',
  fabrics: {poplin: 'Popelina', jersey: 'Punto', denim: 'Tela vaquera', chiffon: 'Gasa'},
  form: 'Maniquí',
  seams: 'Costuras',
  turntable: 'Plato giratorio',
  look: 'Vista desde',
  looks: {
    front: 'Delante',
    back: 'Detrás',
    left: 'Izquierda',
    right: 'Derecha',
    'three-quarter': 'Tres cuartos',
  },
  seen: {
    front: 'Vista de frente.',
    back: 'Vista de espaldas.',
    left: 'Vista desde la izquierda.',
    right: 'Vista desde la derecha.',
    'three-quarter': 'Vista en tres cuartos.',
  },
  worst: (seams, most, seam) => `${seams}; la peor, ${most}: ${seam}.`,
  draping: (percent) => `Drapeando, ${percent}`,
  stop: 'Detener',
  stopped: 'Detenido: la prenda no ha acabado de caer.',
  again: 'Drapear de nuevo',
  waiting: 'Se drapea en cuanto el estampado está alineado',
  truth: 'Una caída, no una promesa de ajuste',
  nextPiece: 'Pieza siguiente',
  pieceBefore: 'Pieza anterior',
  savePicture: 'Guardar una imagen de la prenda',
  saveModel: 'Guardar el modelo 3D (GLB)',
  saveFilm: 'Guardar el vídeo de una vuelta',
  filming: 'Grabando una vuelta, 8 segundos…',
};
