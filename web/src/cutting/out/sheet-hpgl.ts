/** Pieces to cut for plotters and cutters: HP-GL, whose unit is a fortieth of a millimetre. */
import type {Point} from '../../model/geometry.js';
import type {CutSheet} from '../cut-sheet.js';

/** Per centimetre. */
const units = 400;
/** What is cut, and what is drawn on the way, each with a pen of its own. */
const cutPen = 1;
const drawPen = 2;

const place = ([x, y]: Point): string => `${Math.round(units * x)},${Math.round(units * y)}`;

function stroke(points: readonly Point[], isClosed: boolean): string {
  const [first, ...others] = isClosed ? [...points, ...points.slice(0, 1)] : points;
  if (!first) return '';
  return `PU;PA${place(first)};PD;${others.map((p) => `PA${place(p)};`).join('')}PU;`;
}

/** Marks are drawn with pen 2 before pen 1 cuts, as what is cut out no longer lies still. */
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
