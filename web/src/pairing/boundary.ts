/** Walks along the open boundary of a partly sewn garment. */
import type {GarmentDocument} from '../model/garment/garment-document.js';
import type {MeasuredGarment} from './edges.js';
import {numberOf} from './scores.js';

/** An open edge that continues another, across any seams between them. */
export interface Step {
  readonly edge: number;
  /** Interior angle of all pieces where the two edges meet. [rad] */
  readonly angle: number;
}

/** Greatest number of seams that meet in one point. */
const mostMet = 10;

export class Boundary {
  readonly #garment: MeasuredGarment;
  /** The edge that each edge is sewn to, or -1. */
  readonly #mates: Int32Array;
  /** 1 for edges of seams that join start to start; outlines run on the other way beyond them. */
  readonly #isTurned: Uint8Array;

  constructor(garment: MeasuredGarment, {seams}: Pick<GarmentDocument, 'seams'>) {
    this.#garment = garment;
    this.#mates = new Int32Array(garment.edges.length).fill(-1);
    this.#isTurned = new Uint8Array(garment.edges.length);
    for (const {a, b, sameDirection} of seams) {
      const [one, other] = [numberOf(garment, a), numberOf(garment, b)];
      this.#mates[one] = other;
      this.#mates[other] = one;
      if (sameDirection) this.#isTurned[one] = this.#isTurned[other] = 1;
    }
  }

  /** Returns the open edge after the end of an edge; undefined if there is none. */
  after(edge: number): Step | undefined {
    const {edges} = this.#garment;
    let next = edges[edge]?.after ?? edge;
    let angle = edges[next]?.corner ?? 0;
    for (let k = 0; k < mostMet; k++) {
      const mate = this.#mates[next] ?? -1;
      if (mate < 0) return next === edge ? undefined : {edge: next, angle};
      if (this.#isTurned[next] === 1) return undefined;
      next = edges[mate]?.after ?? mate;
      angle += edges[next]?.corner ?? 0;
    }
    return undefined;
  }

  /** Returns the open edge before the start of an edge; undefined if there is none. */
  before(edge: number): Step | undefined {
    const {edges} = this.#garment;
    let angle = edges[edge]?.corner ?? 0;
    let next = edges[edge]?.before ?? edge;
    for (let k = 0; k < mostMet; k++) {
      const mate = this.#mates[next] ?? -1;
      if (mate < 0) return next === edge ? undefined : {edge: next, angle};
      if (this.#isTurned[next] === 1) return undefined;
      angle += edges[mate]?.corner ?? 0;
      next = edges[mate]?.before ?? mate;
    }
    return undefined;
  }
}
