/** Writes a cutting sheet for plotters and cutters in HP-GL, whose unit is 1/40 mm. */
import type {Point} from '../../model/geometry/vectors.js';
import type {CutSheet} from '../cut-sheet.js';

/** Units per centimetre. */
const units = 400;
/** Separate pens for cutting and drawing. */
const cutPen = 1;
const drawPen = 2;

const place = ([x, y]: Point): string => `${Math.round(units * x)},${Math.round(units * y)}`;

function stroke(points: readonly Point[], isClosed: boolean): string {
  const [first, ...others] = isClosed ? [...points, ...points.slice(0, 1)] : points;
  if (!first) return '';
  return `PU;PA${place(first)};PD;${others.map((p) => `PA${place(p)};`).join('')}PU;`;
}

/** The HP-GL text. Pen 2 draws all marks before pen 1 cuts, since cut pieces may shift. */
export function sheetHpgl({pieces}: CutSheet): string {
  const drawn = pieces.flatMap(({marks}) =>
    marks.flatMap((mark) =>
      mark.kind === 'line' && mark.layer !== 'cut' ? [stroke(mark.points, mark.isClosed)] : [],
    ),
  );
  // holes first, for the same reason
  const cut = pieces.flatMap((piece) => [...piece.cut].reverse().map((loop) => stroke(loop, true)));
  return ['IN;', `SP${drawPen};`, ...drawn, `SP${cutPen};`, ...cut, 'SP0;', ''].join('\n');
}
