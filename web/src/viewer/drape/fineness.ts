/** Adapts the resolution of a moving garment to the frame rate. */
import type {Raster} from '../stage.js';

export interface Fineness {
  /** Samples per pixel for multisampling. */
  readonly samples: number;
  /** Greatest number of device px per CSS px. */
  readonly ratio: number;
}

/** Used at rest and for saved pictures. */
export const finest: Fineness = {samples: 4, ratio: Infinity};

/**
 * Software rendering spends half of a frame on multisampling, and half the pixels take half of the
 * rest.
 */
const steps: readonly Fineness[] = [
  finest,
  {samples: 0, ratio: 1},
  {samples: 0, ratio: 0.75},
  {samples: 0, ratio: 0.5},
];

/** Mean frame time that is too slow; displays that save power show 30 frames per second. [ms] */
const slowest = 36;
/** Mean frame time that leaves room for more detail. [ms] */
const fast = 24;
/** A frame that takes this long leaves no time for medium detail: software rendering. [ms] */
const hopeless = 250;
/**
 * Weight of a new frame in the running mean. Three slow frames make it coarser, since two are in
 * flight; one does not, as after a page was hidden.
 */
const weight = 0.1;
/**
 * Number of consecutive fast frames before more detail is tried; it doubles after each failed
 * trial.
 */
const patience = 90;

/** Measures frame times and chooses the fineness of the next frames. */
export class MovingFineness {
  #step = 0;
  /** [ms] */
  #mean = fast;
  #inTime = 0;
  #patience = patience;
  #isTrial = false;

  get now(): Fineness {
    return steps[this.#step] ?? finest;
  }

  /** @param time from one frame's drawing to the earliest next one [ms] */
  took(time: number): void {
    this.#mean += weight * (Math.min(time, 2 * slowest) - this.#mean);
    this.#inTime = this.#mean < fast ? this.#inTime + 1 : 0;
    if (this.#mean > slowest && this.#step < steps.length - 1) {
      if (this.#isTrial) this.#patience *= 2;
      this.#turn(time > hopeless ? steps.length - 1 - this.#step : 1);
    } else if (this.#inTime > this.#patience && this.#step > 0) this.#turn(-1);
  }

  #turn(by: number): void {
    this.#step += by;
    this.#isTrial = by < 0;
    this.#mean = fast;
    this.#inTime = 0;
  }
}

/** Reduces a raster to the fineness. */
export function coarser({width, height, ratio}: Raster, {ratio: most}: Fineness): Raster {
  const share = Math.min(1, most / ratio);
  const side = (length: number): number => Math.max(1, Math.round(share * length));
  return {width: side(width), height: side(height), ratio: share * ratio};
}
