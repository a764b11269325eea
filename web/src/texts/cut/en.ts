/** English texts of the cutting dialog. */
import {cloth} from '../marker/en.js';

export const cutting = {
  title: 'Cut',
  file: 'File',
  files: {pdf: 'PDF', svg: 'SVG', dxf: 'DXF', plt: 'HP-GL'},
  fileNotes: {
    pdf: 'Pages at true scale to print, to glue or to project, with layers.',
    svg: 'One sheet, for print shops and laser cutters.',
    dxf: 'One block for each piece, for CAD programs and cutters (AAMA).',
    plt: 'One sheet of lines, for plotters.',
  },
  paper: 'Paper',
  roll: 'Roll, 36 in',
  projector: 'Projector',
  allowance: cloth.allowance,
  hem: cloth.hem,
  toSize: cloth.toSize,
  print: 'Draw the print on the pieces',
  map: 'How the pages lie',
  sheetMap: 'How the pieces lie',
  pages: (count: number) => (count === 1 ? '1 page' : `${count} pages`),
  each: (paper: string, size: string) => `${paper}, ${size}`,
  sheet: (size: string) => `Sheet ${size}`,
  extent: (width: string, height: string) => `${width} × ${height}`,
  ownAllowances: cloth.ownAllowances,
  waiting: 'Waiting for the print to be aligned …',
  unsolved: 'There is no answer to cut: align the print first.',
  renewed: 'The answer has changed: this is the new one.',
  planning: 'Laying the pieces out …',
  making: 'Making the file …',
  atFullSize: 'Print at 100 %, then measure the squares on the first page.',
  save: (file: string) => `Save ${file}`,
  failed: (message: string) => message,
};

export type CutTexts = typeof cutting;
