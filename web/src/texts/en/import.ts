/** English texts of the import dialog. */
import {text} from '../base/message.js';

export const importing = {
  title: text('Open {file}'),
  reading: text('Reading {file} …'),
  readingPage: text('Reading {file}: page {page, number} of {count, number} …'),
  /** Reasons why a file is no pattern. */
  complaints: {
    unreadable: text(
      '{file} is not a pattern that Seamwise can read, or it is damaged; export it again as PDF, DXF (AAMA or ASTM), SVG or OBJ.',
    ),
    empty: text('{file} is empty; export it again.'),
    outline: text(
      '{file} has no closed outline; join the ends of its lines, or export the pieces as DXF (AAMA or ASTM).',
    ),
    damaged: text('{file} is damaged or incomplete; export it again.'),
    archive: text(
      '{file} is an archive, such as a CLO or Marvelous Designer project; unpack it, or export the pattern as DXF (AAMA or ASTM).',
    ),
    binary: text('{file} is a DWG or binary DXF file; save it as ASCII DXF (R12).'),
    illustrator: text(
      '{file} is in Adobe Illustrator’s own format; choose File > Save a Copy there, and save it as SVG.',
    ),
    model: text(
      '{file} is a 3D model without flat pieces; export it as OBJ with UVs, or export its pattern as DXF (AAMA or ASTM).',
    ),
    plotter: text('{file} is a plotter file (HP-GL); export the pattern as DXF (AAMA or ASTM).'),
    complex: text(
      '{file} draws far more than a sewing pattern does; export the outlines of one garment alone.',
    ),
    locked: text(
      '{file} is locked by a password; open it in a PDF viewer, and save it without one.',
    ),
    picture: text(
      '{file} is a picture; open it as a print, or export the pattern as PDF, DXF or SVG.',
    ),
    postScript: text(
      '{file} is a PostScript file; save it as PDF or SVG, for example with Inkscape.',
    ),
    measurements: text(
      '{file} holds measurements, and no pattern; export the pattern as DXF or SVG.',
    ),
    scan: text(
      '{file} shows scanned pages; only patterns that are drawn with lines can be read, so ask its maker for a PDF with lines.',
    ),
    noPattern: text(
      '{file} shows no page with a pattern; choose the PDF of the pattern, not the one with the instructions.',
    ),
    webPage: text('{file} is a web page; save the pattern itself.'),
    valentina: text(
      '{file} is a Valentina or Seamly2D pattern, whose outlines are formulas; export its layout there as DXF or SVG.',
    ),
  },
  program: text('Drawn with {program}.'),
  which: text('What is {file}?'),
  asPattern: 'A sewing pattern',
  asPatternNote: 'Its lines become pieces to sew.',
  asPrint: 'A print',
  asPrintNote: 'The picture is repeated on the fabric.',
  size: 'Size',
  sample: text('{size} (sample size)'),
  unit: 'Unit of the file',
  largest: text('Largest piece {length}'),
  unitIs: {
    stated: text('unit {unit}, as in the file.'),
    measured: text('unit {unit}, measured on its test square.'),
    size: text('unit {unit}, guessed from the size.'),
    program: text('unit {unit}, as usual for its program.'),
    chosen: text('unit {unit}, chosen.'),
  },
  doubtful: 'Please check it.',
  units: {mm: 'mm', cm: 'cm', inch: 'in', m: 'm'},
  density: 'Pixels per inch',
  asInFile: 'as in the file',
  scale: 'Scale 1 : n',
  pages: 'Pages',
  pageNumbers: 'Page numbers, such as 3-26',
  columns: 'Columns',
  trim: text('Trim ({unit})'),
  overlap: text('Overlap ({unit})'),
  leftOut: text('Left out: {pages}'),
  leaveOut: text('Page {page, number}: drag it to its place, or click to leave it out'),
  takeBack: text('Put page {page, number} back'),
  sheet: 'The pages put together, with the outlines of the pieces',
  included: 'Do the lines include a seam allowance?',
  allowance: text('Seam allowance ({unit})'),
  allowanceNote: 'With 0, the lines are sewn along.',
  lines: 'Lines',
  outerIsCut: 'The outer line is the cut line',
  outerIsCutNote: 'The inner line is the seam line. If this is off, the outer line is.',
  notes: 'Notes',
  pieces: 'Pieces',
  toScale: 'All at the same scale',
  all: 'All',
  none: 'None',
  cut: text('Copies of {piece}'),
  once: 'Cut once',
  pair: 'Cut a pair',
  extent: text('{width} × {height}'),
  holeOrLine: 'A hole, or a line on the piece?',
  hole: text('Hole, {size}'),
  lineOn: text('Line on the piece, {size}'),
  half: 'half, on the fold',
  ruler: text('Ruler, {length}'),
  taken: text('{count, number} of {all, plural, one {# piece} other {# pieces}}'),
  open: 'Open',
};

export type ImportTexts = typeof importing;
