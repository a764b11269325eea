/** How finely a garment is drawn while it moves: as finely as its frames come in time. */
import type {Raster} from '../stage.js';

export interface Fineness {
  /** Of a pixel's edges. */
  readonly samples: number;
  /** At most so many pixels for each of CSS. */
  readonly ratio: number;
}

/** Of what rests, and of pictures to keep. */
export const finest: Fineness = {samples: 4, ratio: Infinity};

/** In software, multisampling takes half of a frame's time, and half the pixels half of the rest. */
const steps: readonly Fineness[] = [
  finest,
  {samples: 0, ratio: 1},
  {samples: 0, ratio: 0.75},
  {samples: 0, ratio: 0.5},
];

/** Frames that take longer are too slow; displays that save power show 30 in a second. [ms] */
const slowest = 36;
/** Frames that take less would leave time for finer ones. [ms] */
const fast = 24;
/** Not a frame: the page was asleep. [ms] */
const asleep = 1000;
/** Of a new frame in the mean of those before. So it takes three slow ones to be coarser, since two are under way. */
const weight = 0.1;
/** In time one after the other before finer ones are tried; twice as many after every trial in vain. */
const patience = 90;

/** What frames took, and what that means for the next ones. */
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

  /** @param time from where a frame was drawn to where the next one could be [ms] */
  took(time: number): void {
    if (time > asleep) return;
    this.#mean += weight * (Math.min(time, 2 * slowest) - this.#mean);
    this.#inTime = this.#mean < fast ? this.#inTime + 1 : 0;
    if (this.#mean > slowest && this.#step < steps.length - 1) {
      if (this.#isTrial) this.#patience *= 2;
      this.#turn(1);
    } else if (this.#inTime > this.#patience && this.#step > 0) this.#turn(-1);
  }

  #turn(by: 1 | -1): void {
    this.#step += by;
    this.#isTrial = by < 0;
    this.#mean = fast;
    this.#inTime = 0;
  }
}

/** A picture of so many pixels at most. */
export function coarser({width, height, ratio}: Raster, {ratio: most}: Fineness): Raster {
  const share = Math.min(1, most / ratio);
  const side = (length: number): number => Math.max(1, Math.round(share * length));
  return {width: side(width), height: side(height), ratio: share * ratio};
}
