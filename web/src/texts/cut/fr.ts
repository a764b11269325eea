/** French texts of the cutting dialog. */
import {cloth} from '../marker/fr.js';
import type {CutTexts} from './en.js';

export const cutting: CutTexts = {
  title: 'Couper',
  file: 'Fichier',
  files: {pdf: 'PDF', svg: 'SVG', dxf: 'DXF', plt: 'HP-GL'},
  fileNotes: {
    pdf: 'Pages en vraie grandeur à imprimer, à coller ou à projeter, avec calques.',
    svg: 'Une seule feuille, pour imprimeurs et découpe laser.',
    dxf: 'Un bloc par pièce, pour logiciels de CAO et tables de coupe (AAMA).',
    plt: 'Une feuille de lignes, pour traceurs.',
  },
  paper: 'Papier',
  roll: 'Rouleau, 36 pouces',
  projector: 'Projecteur',
  allowance: cloth.allowance,
  hem: cloth.hem,
  toSize: cloth.toSize,
  print: 'Dessiner l’imprimé sur les pièces',
  map: 'Disposition des pages',
  sheetMap: 'Disposition des pièces',
  pages: (count) => (count === 1 ? '1 page' : `${count} pages`),
  each: (paper, size) => `${paper}, ${size}`,
  sheet: (size) => `Feuille ${size}`,
  extent: (width, height) => `${width} × ${height}`,
  ownAllowances: cloth.ownAllowances,
  waiting: 'L’imprimé est encore en cours d’alignement…',
  unsolved: 'Rien à couper encore : alignez d’abord l’imprimé.',
  renewed: 'Le résultat a changé : voici le nouveau.',
  planning: 'Disposition des pièces …',
  making: 'Création du fichier …',
  atFullSize: 'Imprimez à 100 %, puis mesurez les carrés de la première page.',
  save: (file) => `Enregistrer ${file}`,
  failed: (message) => `Le fichier n’a pas été créé. En anglais : ${message}`,
};
