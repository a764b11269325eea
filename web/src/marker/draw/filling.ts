/** Sheets of a lay plan as they are filled from their tops. Lengths in cm at the scale of the cloth, but where mm on paper are said. */
import type {CutMark} from '../../cutting/cut-sheet.js';
import type {Point} from '../../model/geometry.js';
import {cm, sizeAt, type Size} from './plan-style.js';

export interface PlanSheet {
  readonly widthCm: number;
  readonly heightCm: number;
  /** The cloth between two cuts across. */
  readonly cloth?: {
    /** Where on the sheet the start of the cloth lies, at its left edge. */
    readonly at: Point;
    readonly from: number;
    readonly to: number;
    /** On the cloth, from its start; they end where it is cut. */
    readonly marks: readonly CutMark[];
  };
  readonly marks: readonly CutMark[];
}

/** How sheets are made of a plan. */
export interface SheetFormat {
  /** At 1 : scale. */
  readonly scale: number;
  readonly widthCm: number;
  /** One that is as high as needed has at most this. */
  readonly heightCm: number;
  readonly isAsHighAsNeeded: boolean;
  /** Around everything; none of a roll, which is as wide as the cloth and has its rulers on it. */
  readonly marginCm: number;
  readonly isRoll: boolean;
}

/** Words keep away from the edges of a roll. [mm on paper] */
const rollInset = 8;

export const moved = (marks: readonly CutMark[], [dx, dy]: Point): readonly CutMark[] =>
  marks.map((mark): CutMark => {
    const by = ([x, y]: Point): Point => [x + dx, y + dy];
    return mark.kind === 'text'
      ? {...mark, at: by(mark.at)}
      : {...mark, points: mark.points.map(by)};
  });

/** Each is drawn from its upper edge down, until it is turned. */
export class Filling {
  readonly done: PlanSheet[] = [];
  readonly size: Size;
  readonly #format: SheetFormat;
  #marks: CutMark[] = [];
  #cloth: PlanSheet['cloth'];
  /** From the top, with the margin. */
  #used: number;

  constructor(format: SheetFormat) {
    this.#format = format;
    this.size = sizeAt(format.scale);
    this.#used = format.marginCm;
  }

  /** What is left of the sheet above its margin. */
  get left(): number {
    return this.#format.heightCm - this.#format.marginCm - this.#used;
  }

  get isFresh(): boolean {
    return this.#marks.length === 0 && !this.#cloth;
  }

  /** The next sheet. */
  turn(): void {
    const {marginCm, heightCm: most, widthCm, isAsHighAsNeeded} = this.#format;
    const heightCm = isAsHighAsNeeded ? this.#used + marginCm : most;
    const cloth = this.#cloth;
    this.done.push({
      ...{widthCm, heightCm, marks: moved(this.#marks, [0, heightCm])},
      ...(cloth && {cloth: {...cloth, at: [cloth.at[0], cloth.at[1] + heightCm]}}),
    });
    this.#marks = [];
    this.#cloth = undefined;
    this.#used = marginCm;
  }

  /** @param draw from the left end of its upper edge on */
  add(height: number, draw: (at: Point) => readonly CutMark[] = () => []): void {
    const inset = this.#format.isRoll ? cm(this.size, rollInset) : 0;
    this.#put(height, ([x, y]) => draw([x + inset, y]));
  }

  /**
   * A part of the cloth, for which there has to be room.
   * @param room of rulers, left of it and below
   * @param rulers from the start of the cloth on, at its left edge
   */
  addCloth(
    [from, to]: Point,
    [beside, below]: Point,
    marks: readonly CutMark[],
    rulers: readonly CutMark[],
  ): void {
    this.#put(to - from + below, ([x, y]) => {
      const at: Point = [x + beside, y - to];
      this.#cloth = {at, from, to, marks};
      return moved(rulers, at);
    });
  }

  #put(height: number, draw: (at: Point) => readonly CutMark[]): void {
    if (height > this.left + 1e-9 && !this.isFresh) this.turn();
    this.#marks.push(...draw([this.#format.marginCm, -this.#used]));
    this.#used += height;
  }
}
