/** German texts of the cutting dialog. */
import {cloth} from '../marker/de.js';
import type {CutTexts} from './en.js';

export const cutting: CutTexts = {
  title: 'Zuschneiden',
  file: 'Datei',
  files: {pdf: 'PDF', svg: 'SVG', dxf: 'DXF', plt: 'HP-GL'},
  fileNotes: {
    pdf: 'Seiten in wahrer Größe zum Drucken, Kleben oder Projizieren, mit Ebenen.',
    svg: 'Ein Bogen, für Druckereien und Laserschneider.',
    dxf: 'Ein Block je Teil, für CAD-Programme und Cutter (AAMA).',
    plt: 'Ein Bogen aus Linien, für Plotter.',
  },
  paper: 'Papier',
  roll: 'Rolle, 36 Zoll',
  projector: 'Projektor',
  allowance: cloth.allowance,
  hem: cloth.hem,
  toSize: cloth.toSize,
  print: 'Den Druck auf die Teile zeichnen',
  map: 'Wie die Seiten liegen',
  sheetMap: 'Wie die Teile liegen',
  pages: (count) => (count === 1 ? '1 Seite' : `${count} Seiten`),
  each: (paper, size) => `${paper}, ${size}`,
  sheet: (size) => `Bogen ${size}`,
  extent: (width, height) => `${width} × ${height}`,
  ownAllowances: cloth.ownAllowances,
  waiting: 'Das Muster wird noch ausgerichtet …',
  unsolved: 'Es gibt noch kein Ergebnis: zuerst das Muster ausrichten.',
  renewed: 'Das Ergebnis ist ein anderes geworden: dies ist das neue.',
  planning: 'Die Teile werden ausgelegt …',
  making: 'Die Datei entsteht …',
  atFullSize: 'Mit 100 % drucken, dann die Quadrate auf der ersten Seite nachmessen.',
  save: (file) => `${file} speichern`,
  failed: (message) => `Die Datei ist nicht entstanden. Auf Englisch: ${message}`,
};
