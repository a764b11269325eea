/**
 * Draws the fabric of a layout and its pieces, between two cuts across. Lengths in cm on the
 * fabric.
 */
import {leastLetterMm, type CutMark} from '../../cutting/cut-sheet.js';
import {plus, towards, type Point} from '../../model/geometry/vectors.js';
import {boxOf, distanceTo, isInside, type Box} from '../../model/geometry/polyline.js';
import {boxOfMark} from '../../paper/draw-marks.js';
import {boxAt, cornersOf, overlap, shared} from '../../paper/boxes.js';
import {placeIn} from '../../paper/words-on-page.js';
import {inmost, type PlanPiece} from './plan-pieces.js';
import {cm, lineOf, textOf, type Size} from './plan-style.js';

/** Layout data that the drawing uses. */
export interface DrawnFabric {
  readonly widthCm: number;
  readonly lengthCm: number;
  readonly selvedgeCm: number;
  readonly pieces: readonly PlanPiece[];
  /** A corner of the print's repeat. */
  readonly ring: Point | undefined;
}

/** Letter heights of labels, largest first. [mm on paper] */
const labelSizes = [3.4, 2.8, leastLetterMm];
const numberSize = leastLetterMm;
/** Width allowance for fonts with wider letters, as a factor. */
const fontRoom = 1.25;
/** Half the size of a cross, and the distance of its number from its centre. [mm on paper] */
const crossReach = 1.3;
const numberAside = 3.1;
/** Width of lines inside pieces, and their dashes over those of a cutting sheet. [mm on paper, 1] */
const thin = 0.2;
const dashShare = 0.5;
const ringRadius = 1.6;
const ringSteps = 24;
const upright = Math.PI / 2;

const cross = ([x, y]: Point, reach: number): readonly (readonly Point[])[] => [
  [
    [x - reach, y],
    [x + reach, y],
  ],
  [
    [x, y - reach],
    [x, y + reach],
  ],
];

/** The position beside a cross with the greatest clearance inside the piece. */
function besideCross(at: Point, cut: readonly Point[], aside: number): Point {
  const places = [45, -45, 135, -135].map((turn) =>
    plus(at, towards((turn * Math.PI) / 180), aside),
  );
  const room = (p: Point): number => (isInside(cut, p) ? Math.min(aside, distanceTo(cut, p)) : 0);
  return places.reduce((best, p) => (room(p) > room(best) + 1e-9 ? p : best));
}

function crossMarks(size: Size, {cut, crosses}: PlanPiece): readonly CutMark[] {
  const numbers = crosses.map((at, k) =>
    textOf(size, besideCross(at, cut, cm(size, numberAside)), String(k + 1), numberSize, {
      ...{layer: 'matches', hasPlate: true},
    }),
  );
  const lines = crosses
    .flatMap((at) => cross(at, cm(size, crossReach)))
    .map((points) => lineOf(size, points, {width: 0.3, halo: 0.5, layer: 'matches'}));
  return [...numbers, ...lines];
}

/**
 * Cut-outs, sewn lines, notches, drill holes, inner lines and grain of a piece, as on its cutting
 * sheet.
 */
const marksInside = (size: Size, {laid}: PlanPiece): readonly CutMark[] =>
  laid
    ? [
        ...laid.cut
          .slice(1)
          .map((hole) => lineOf(size, hole, {width: 0.4, halo: 0.5, isClosed: true, layer: 'cut'})),
        ...laid.marks.flatMap((mark) =>
          mark.kind === 'line' && (mark.layer === 'sew' || mark.layer === 'marks')
            ? [
                lineOf(size, mark.points, {
                  ...{width: thin, halo: thin, isClosed: mark.isClosed, layer: mark.layer},
                  ...(mark.dashMm && {dash: mark.dashMm.map((part) => dashShare * part)}),
                }),
              ]
            : [],
        ),
      ]
    : [];

/**
 * The number and name of a piece, in the largest size that fits the piece and the window,
 * horizontal or vertical; otherwise the number alone.
 */
function labelOf(
  size: Size,
  {number, name, cut, crosses}: PlanPiece,
  window: Box,
  others: readonly Box[],
): readonly CutMark[] {
  const frame = shared(boxOf(cut), window);
  if (!overlap(frame, window)) return [];
  const {at} = inmost(cut, crosses);
  const isOneLine = [`${number}  ${name}`];
  const variants = labelSizes.flatMap((mm) => [
    {lines: [String(number), name], mm, angle: 0},
    {lines: isOneLine, mm, angle: 0},
    {lines: isOneLine, mm, angle: upright},
  ]);
  const alone = {lines: [String(number)], mm: numberSize, angle: 0};
  for (const {lines, mm, angle} of [...variants, alone]) {
    const label = textOf(size, at, lines, mm, {hasPlate: true, angle});
    // other fonts have wider letters
    const wider = {...label, sizeMm: label.sizeMm * fontRoom};
    const place = placeIn(frame, wider, {sewn: [cut]}, others);
    if (place) return [{...label, at: place}];
  }
  // nothing fits: the number covers the lines
  return isInside(cornersOf(window), at)
    ? [textOf(size, at, [String(number)], numberSize, {hasPlate: true})]
    : [];
}

/** Marks on the fabric from `from` to `to`; the caller clips them. */
export function fabricMarks(
  size: Size,
  {widthCm, lengthCm, selvedgeCm, pieces, ring}: DrawnFabric,
  [from, to]: Point,
): readonly CutMark[] {
  const window = boxAt([0, from], widthCm, to - from);
  const along = (x: number): readonly Point[] => [
    [x, from],
    [x, to],
  ];
  const shown = pieces.filter(({cut}) => overlap(boxOf(cut), window));
  const ringMarks =
    ring === undefined
      ? []
      : [
          lineOf(
            size,
            Array.from({length: ringSteps}, (_, k) =>
              plus(ring, towards((2 * Math.PI * k) / ringSteps), cm(size, ringRadius)),
            ),
            {width: 0.4, halo: 0.6, isClosed: true, layer: 'matches'},
          ),
        ];
  return [
    ...(selvedgeCm > 0 ? [selvedgeCm, widthCm - selvedgeCm] : []).map((x) =>
      lineOf(size, along(x), {width: 0.2, dash: [2, 1]}),
    ),
    ...shown.map(({cut}) =>
      lineOf(size, cut, {width: 0.4, halo: 0.5, isClosed: true, layer: 'cut'}),
    ),
    ...shown.flatMap((piece) => marksInside(size, piece)),
    ...ringMarks,
    ...shown.flatMap((piece) => {
      const crosses = crossMarks(size, piece);
      return [
        ...crosses,
        ...labelOf(size, piece, window, [...crosses, ...ringMarks].map(boxOfMark)),
      ];
    }),
    ...[0, widthCm].map((x) => lineOf(size, along(x), {width: 0.4})),
    ...[0, lengthCm].map((y) =>
      lineOf(
        size,
        [
          [0, y],
          [widthCm, y],
        ],
        {width: 0.4},
      ),
    ),
  ];
}

interface RulerStyle {
  /** Distance of ticks in the ruler's unit. Every `long`-th tick is longer and has a number. */
  readonly step: number;
  readonly long: number;
  /** Length of the ruler's unit. [cm] */
  readonly unitCm: number;
  /** Side of the ticks; 1 is left of the ruler's direction. */
  readonly side: 1 | -1;
  readonly hasPlate: boolean;
}

/**
 * Ticks and numbers along an edge of the fabric.
 * @param axis 0 across the fabric, 1 along it
 */
export function ruler(
  size: Size,
  axis: 0 | 1,
  [from, to]: Point,
  {step, long, unitCm, side, hasPlate}: RulerStyle,
): readonly CutMark[] {
  const place = (along: number, aside: number): Point =>
    axis === 0 ? [along, -side * aside] : [-side * aside, along];
  const first = Math.ceil(from / (step * unitCm) - 1e-9);
  const count = Math.floor(to / (step * unitCm) + 1e-9) - first + 1;
  return Array.from({length: Math.max(0, count)}, (_, k) => first + k).flatMap((n): CutMark[] => {
    const at = n * step * unitCm;
    const isLong = n % long === 0;
    const tick = lineOf(size, [place(at, 0), place(at, cm(size, isLong ? 2.2 : 1.2))], {
      width: isLong ? 0.25 : 0.18,
      ...(hasPlate && {halo: 0.4}),
    });
    if (!isLong) return [tick];
    const label = textOf(
      size,
      place(at, cm(size, axis === 0 ? 4 : 2.8)),
      String(n * step),
      leastLetterMm,
      {
        align: axis === 0 ? 'middle' : side > 0 ? 'right' : 'left',
        hasPlate,
      },
    );
    return [tick, label];
  });
}
