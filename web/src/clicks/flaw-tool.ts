/** Draws a flaw on the fabric: a dragged box, or corners clicked one by one. */
import type {Point} from '../model/geometry/vectors.js';
import {signedArea} from '../model/geometry/polyline.js';

/** A smaller box is a click. [cm2] */
const leastArea = 0.25;

const boxBetween = ([ax, ay]: Point, [bx, by]: Point): readonly Point[] => [
  [ax, ay],
  [bx, ay],
  [bx, by],
  [ax, by],
];

export class FlawTool {
  #corners: readonly Point[] = [];
  /** Start of the press, and present position of the pointer. */
  #from: Point | undefined;
  #at: Point | undefined;

  get draft(): readonly Point[] {
    if (this.#from && this.#at) {
      const box = boxBetween(this.#from, this.#at);
      if (this.#corners.length === 0) return box;
    }
    return this.#at ? [...this.#corners, this.#at] : this.#corners;
  }

  press(at: Point): void {
    [this.#from, this.#at] = [at, at];
  }

  move(at: Point): void {
    if (this.#from || this.#corners.length > 0) this.#at = at;
  }

  /** @returns the box after a drag; a click adds a corner */
  release(at: Point): readonly Point[] | undefined {
    const from = this.#from;
    this.#from = undefined;
    if (!from) return undefined;
    const box = boxBetween(from, at);
    if (this.#corners.length === 0 && Math.abs(signedArea(box)) > leastArea) {
      this.#at = undefined;
      return signedArea(box) < 0 ? [...box].reverse() : box;
    }
    this.#corners = [...this.#corners, at];
    this.#at = at;
    return undefined;
  }

  /** @returns the polygon of the corners, if it has an area */
  close(): readonly Point[] | undefined {
    const corners = this.#corners;
    [this.#corners, this.#at, this.#from] = [[], undefined, undefined];
    const area = signedArea(corners);
    if (Math.abs(area) < leastArea) return undefined;
    return area < 0 ? [...corners].reverse() : corners;
  }
}
