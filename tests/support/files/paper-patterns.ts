/** A small garment as makers of paper patterns draw it. Lengths in mm, y up. */
import type {DrawnLabel, DrawnStroke, Outline, PatternSheet, Place} from './drawn-pdf.js';

/** Grows an outline from the lower left corner, as sizes of a nest grow. */
export function grown({start, steps, isOpen}: Outline, by: number, [x, y]: Place): Outline {
  const at = ([px, py]: Place): Place => [x + px * (1 + by), y + py * (1 + by)];
  return {
    start: at(start),
    steps: steps.map((step) => step.map(at) as [Place]),
    ...(isOpen && {isOpen}),
  };
}

const line = (...points: readonly Place[]): Outline['steps'] => points.map((p) => [p]);

/** Half of a bodice; its fold is at x = 0. */
const bodice: Outline = {
  start: [0, 0],
  steps: [
    ...line([260, 0], [250, 220]),
    [
      [210, 230],
      [190, 300],
      [200, 380],
    ],
    ...line([80, 400]),
    [
      [75, 350],
      [40, 330],
      [0, 330],
    ],
  ],
};

/** The bodice without its fold, and the fold alone. */
export const openBodice: Outline = {...bodice, isOpen: true};

const sleeve: Outline = {
  start: [40, 0],
  steps: [
    ...line([280, 0], [320, 260]),
    [
      [250, 280],
      [230, 390],
      [160, 390],
    ],
    [
      [90, 390],
      [70, 280],
      [0, 260],
    ],
  ],
};

const pocket: Outline = {start: [0, 0], steps: line([140, 0], [140, 160], [0, 160])};

export const places = {
  front: [30, 30],
  back: [340, 30],
  sleeve: [30, 480],
  pocket: [400, 500],
} as const;

/** The width of the pieces as drawn, and their height. */
export const extents = {
  front: [260, 400],
  back: [260, 400],
  sleeve: [320, 390],
  pocket: [140, 160],
} as const;

export const size: Place = [640, 920];

/** Words on the pieces, in one language. */
export interface PieceWords {
  readonly front: readonly string[];
  readonly back: readonly string[];
  readonly sleeve: readonly string[];
  readonly pocket: readonly string[];
}

export const english: PieceWords = {
  front: ['Front', 'Cut 1 on fold'],
  back: ['Back', 'Cut 1 on fold'],
  sleeve: ['Sleeve', 'Cut 2'],
  pocket: ['Pocket', 'Cut 1'],
};

const outlines = {front: bodice, back: bodice, sleeve, pocket};

/** The strokes of all pieces in one size. */
export const piecesIn = (by: number, more: Partial<DrawnStroke> = {}): DrawnStroke[] =>
  (['front', 'back', 'sleeve', 'pocket'] as const).map((name) => ({
    outline: grown(outlines[name], by, places[name]),
    ...more,
  }));

/** An arrow upwards with heads of two strokes. */
function grainArrow([x, y]: Place, length: number): DrawnStroke[] {
  const head = (tip: number, back: number): Outline => ({
    start: [x - 4, back],
    steps: line([x, tip], [x + 4, back]),
    isOpen: true,
  });
  return [
    {start: [x, y] as const, steps: line([x, y + length]), isOpen: true},
    head(y + length, y + length - 8),
    head(y, y + 8),
  ].map((outline) => ({outline}));
}

/** Words and grain lines of all pieces. */
function marksOf(words: PieceWords): Pick<PatternSheet, 'strokes' | 'labels'> {
  const names = ['front', 'back', 'sleeve', 'pocket'] as const;
  return {
    strokes: names.flatMap((name) => {
      const [x, y] = places[name];
      return grainArrow([x + 110, y + 40], 100);
    }),
    labels: names.flatMap((name) => {
      const [x, y] = places[name];
      return words[name].map((text, k): DrawnLabel => ({
        at: [x + 45, y + 140 - 10 * k - 25],
        text,
        size: k === 0 ? 8 : 5,
      }));
    }),
  };
}

/** A test square with its label. */
const testSquare: Pick<PatternSheet, 'strokes' | 'labels'> = {
  strokes: [{outline: {start: [560, 700], steps: line([610, 700], [610, 750], [560, 750])}}],
  labels: [{at: [565, 720], text: '5 cm x 5 cm', size: 4}],
};

/** The sheet of one size. */
export function plainSheet(
  words: PieceWords = english,
  strokes: readonly DrawnStroke[] = piecesIn(0),
): PatternSheet {
  const marks = marksOf(words);
  return {
    width: size[0],
    height: size[1],
    strokes: [...strokes, ...marks.strokes, ...testSquare.strokes],
    labels: [...marks.labels, ...testSquare.labels],
  };
}
