/** Sizes and small marks of a drawn layout, all in proportion to one size. */
import type {CutLayer, CutLine, CutMark, CutText} from '../../cutting/cut-sheet.js';
import type {Point} from '../../model/geometry/vectors.js';

/** Millimetres on the fabric per millimetre on paper, for lines, letters and distances. */
export type Size = number;

/**
 * The size of a layout at 1 : scale. At true scale it is larger, since people read it from farther
 * away.
 */
const sizeAt = (scale: number): Size => (scale === 1 ? 2.5 : scale);

/** Converts millimetres on paper to centimetres on the fabric, or on a sheet at its scale. */
export const cm = (size: Size, mm: number): number => (size * mm) / 10;

interface LineStyle {
  /** [mm on paper] */
  readonly width: number;
  readonly dash?: readonly number[];
  readonly halo?: number;
  readonly isFaint?: boolean;
  readonly isClosed?: boolean;
  readonly layer?: CutLayer;
}

export const lineOf = (
  size: Size,
  points: readonly Point[],
  {width, dash, halo, isFaint, isClosed = false, layer = 'marks'}: LineStyle,
): CutLine => ({
  ...{kind: 'line', layer, points, isClosed, widthMm: size * width},
  ...(dash && {dashMm: dash.map((part) => size * part)}),
  ...(halo !== undefined && {haloMm: size * halo}),
  ...(isFaint && {isFaint}),
});

/**
 * A text mark.
 * @param mm letter height on paper
 */
export const textOf = (
  size: Size,
  at: Point,
  words: string | readonly string[],
  mm: number,
  style: Partial<Pick<CutText, 'layer' | 'hasPlate' | 'angle' | 'align' | 'weight'>> = {},
): CutText => ({
  ...{kind: 'text', layer: 'words', at, sizeMm: size * mm, hasPlate: false},
  lines: typeof words === 'string' ? [words] : words,
  ...(typeof words === 'string' && {weight: 'regular'}),
  ...style,
});

/**
 * Fills the sheets of a layout from the top down. Lengths are in cm at the fabric's scale, unless
 * given in mm on paper.
 */
export interface PlanSheet {
  readonly widthCm: number;
  readonly heightCm: number;
  /** The fabric between two cuts across. */
  readonly fabric?: {
    /** Position of the fabric's start at its left edge, on the sheet. */
    readonly at: Point;
    readonly from: number;
    readonly to: number;
    /** Marks relative to the start of the fabric, clipped to the part shown. */
    readonly marks: readonly CutMark[];
    /** Cut-outs of the pieces. */
    readonly holes: readonly (readonly Point[])[];
  };
  readonly marks: readonly CutMark[];
}

/** Sheet size and scale. */
export interface SheetFormat {
  /** The denominator of the scale 1 : n. */
  readonly scale: number;
  readonly widthCm: number;
  /** Sheet height; the greatest height if sheets are as high as needed. */
  readonly heightCm: number;
  readonly isAsHighAsNeeded: boolean;
  /** Margin on all sides. A roll has none: it is as wide as the fabric and includes the rulers. */
  readonly marginCm: number;
  readonly isRoll: boolean;
}

/** Distance of text from the edges of a roll. [mm on paper] */
const rollInset = 8;

export const moved = (marks: readonly CutMark[], [dx, dy]: Point): readonly CutMark[] =>
  marks.map((mark): CutMark => {
    const by = ([x, y]: Point): Point => [x + dx, y + dy];
    return mark.kind === 'text'
      ? {...mark, at: by(mark.at)}
      : {...mark, points: mark.points.map(by)};
  });

/** Fills each sheet from its upper edge down and then starts the next one. */
export class Filling {
  readonly done: PlanSheet[] = [];
  readonly size: Size;
  readonly #format: SheetFormat;
  #marks: CutMark[] = [];
  #fabric: PlanSheet['fabric'];
  /** Height used from the top, margin included. */
  #used: number;

  constructor(format: SheetFormat) {
    this.#format = format;
    this.size = sizeAt(format.scale);
    this.#used = format.marginCm;
  }

  /** Free height of the current sheet above its lower margin. */
  get left(): number {
    return this.#format.heightCm - this.#format.marginCm - this.#used;
  }

  get isFresh(): boolean {
    return this.#marks.length === 0 && !this.#fabric;
  }

  /** Finishes the current sheet and starts the next one. */
  turn(): void {
    const {marginCm, heightCm: most, widthCm, isAsHighAsNeeded} = this.#format;
    const heightCm = isAsHighAsNeeded ? this.#used + marginCm : most;
    const fabric = this.#fabric;
    this.done.push({
      ...{widthCm, heightCm, marks: moved(this.#marks, [0, heightCm])},
      ...(fabric && {fabric: {...fabric, at: [fabric.at[0], fabric.at[1] + heightCm]}}),
    });
    this.#marks = [];
    this.#fabric = undefined;
    this.#used = marginCm;
  }

  /**
   * Adds a block.
   * @param draw receives the left end of the block's upper edge
   */
  add(height: number, draw: (at: Point) => readonly CutMark[] = () => []): void {
    const inset = this.#format.isRoll ? cm(this.size, rollInset) : 0;
    this.#put(height, ([x, y]) => draw([x + inset, y]));
  }

  /**
   * Adds a part of the fabric, which has to fit the sheet.
   * @param room space for rulers to the left and below
   * @param rulers relative to the start of the fabric at its left edge
   */
  addFabric(
    [from, to]: Point,
    [beside, below]: Point,
    drawn: Pick<NonNullable<PlanSheet['fabric']>, 'marks' | 'holes'>,
    rulers: readonly CutMark[],
  ): void {
    this.#put(to - from + below, ([x, y]) => {
      const at: Point = [x + beside, y - to];
      this.#fabric = {at, from, to, ...drawn};
      return moved(rulers, at);
    });
  }

  #put(height: number, draw: (at: Point) => readonly CutMark[]): void {
    if (height > this.left + 1e-9 && !this.isFresh) this.turn();
    this.#marks.push(...draw([this.#format.marginCm, -this.#used]));
    this.#used += height;
  }
}
