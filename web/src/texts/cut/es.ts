/** Spanish texts of the cutting dialog. */
import {cloth} from '../marker/es.js';
import type {CutTexts} from './en.js';

export const cutting: CutTexts = {
  title: 'Cortar',
  file: 'Archivo',
  files: {pdf: 'PDF', svg: 'SVG', dxf: 'DXF', plt: 'HP-GL'},
  fileNotes: {
    pdf: 'Páginas a tamaño real para imprimir, pegar o proyectar, con capas.',
    svg: 'Una sola hoja, para imprentas y corte por láser.',
    dxf: 'Un bloque por pieza, para programas CAD y mesas de corte (AAMA).',
    plt: 'Una hoja de líneas, para trazadores.',
  },
  paper: 'Papel',
  roll: 'Rollo, 36 pulgadas',
  projector: 'Proyector',
  allowance: cloth.allowance,
  hem: cloth.hem,
  toSize: cloth.toSize,
  print: 'Dibujar el estampado en las piezas',
  map: 'Cómo van las páginas',
  sheetMap: 'Cómo van las piezas',
  pages: (count) => (count === 1 ? '1 página' : `${count} páginas`),
  each: (paper, size) => `${paper}, ${size}`,
  sheet: (size) => `Hoja ${size}`,
  extent: (width, height) => `${width} × ${height}`,
  ownAllowances: cloth.ownAllowances,
  waiting: 'El estampado todavía se está alineando…',
  unsolved: 'Aún no hay nada que cortar: alinea primero el estampado.',
  renewed: 'El resultado ha cambiado: este es el nuevo.',
  planning: 'Colocando las piezas …',
  making: 'Creando el archivo …',
  atFullSize: 'Imprime al 100 % y mide los cuadrados de la primera página.',
  save: (file) => `Guardar ${file}`,
  failed: (message) => `No se ha creado el archivo. En inglés: ${message}`,
};
