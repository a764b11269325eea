/** English texts of the cutting dialog. */
import {text} from '../base/message.js';
import {marker} from './marker.js';

export const cutting = {
  title: 'Cut',
  file: 'File',
  files: {pdf: 'PDF', svg: 'SVG', dxf: 'DXF', plt: 'HP-GL'},
  fileNotes: {
    pdf: 'Pages at true scale to print and glue, or to project, with layers.',
    svg: 'One sheet, for print shops and laser cutters.',
    dxf: 'One block for each piece, for CAD programs and cutters.',
    plt: 'One sheet of lines, for plotters.',
  },
  dxfStyle: 'Format',
  dxfStyles: {aama: 'AAMA-292', astm: 'ASTM D6673'},
  dxfUnit: 'Unit',
  dxfUnits: {mm: 'Millimetres', in: 'Inches'},
  paper: 'Paper',
  roll: 'Roll, 36 in',
  projector: 'Projector',
  allowance: marker.allowance,
  hem: marker.hem,
  toSize: marker.toSize,
  ink: 'Print on the pieces',
  inks: {full: 'Full', pale: 'Pale', outline: 'Lines only'},
  guide: 'My fabric is printed already: add a placing guide',
  guideNote: 'Shows motifs at two or three points of each piece, and their distances.',
  map: 'Arrangement of the pages',
  sheetMap: 'Arrangement of the pieces',
  pages: text('{count, plural, one {# page} other {# pages}}'),
  withGuide: text('with {count, plural, one {# page} other {# pages}} of placing guide'),
  each: text('{paper}, {size}'),
  sheet: text('Sheet {size}'),
  extent: text('{width} × {height}'),
  ownAllowances: marker.ownAllowances,
  waiting: 'Waiting for the print to be matched …',
  unsolved: 'Match the print first; then the pattern can be cut.',
  renewed: 'The match has changed; this is the new one.',
  planning: 'Arranging the pieces …',
  making: 'Making the file …',
  atFullSize: 'Print at 100 %, then measure the squares on the first page.',
  save: text('Save {file}'),
  failed: text('{message}'),
};

export type CutTexts = typeof cutting;
