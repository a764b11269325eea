/** Conditions of photos, by level. */
import {castOf, type Lamps} from './lamps.js';
import type {Chance} from './chance.js';

export type PhotoLevel = 'scan' | 'normal' | 'hard';

export interface Conditions {
  readonly level: PhotoLevel;
  readonly f35: number;
  /** [rad] */
  readonly tilt: number;
  readonly axis: number;
  readonly turn: number;
  /** Repeats across the image's longer side; the unit is the square root of the cell's area. */
  readonly repeats: number;
  /** A cell takes at most 1 / cellsShown of the shorter side, as a repeat must be visible twice. */
  readonly cellsShown: number;
  /** k of the lens, at half the longer side. */
  readonly lens: number;
  /** Greatest displacement by creases, as a share of a repeat. */
  readonly creases: number;
  readonly lamps: Lamps;
  /** Relative strength of the threads' pattern. */
  readonly weave: number;
  /** [px] */
  readonly defocus: number;
  readonly motion: number;
  readonly iso: number;
  readonly halo: number;
  /** Quality of the JPEG file, 0 to 100. */
  readonly quality: number;
  /** Share of the frame's sides that is kept; 1 is all. */
  readonly crop: number;
}

const degrees = Math.PI / 180;

function scan(chance: Chance): Conditions {
  return {
    level: 'scan',
    f35: 35,
    tilt: 0,
    axis: 0,
    turn: chance.whole(0, 3) * 90 * degrees + chance.between(-2, 2) * degrees,
    repeats: chance.between(2.8, 6),
    cellsShown: 2.4,
    lens: 0,
    creases: chance.between(0, 0.001),
    lamps: {least: chance.between(0.95, 0.99), vignette: 0, cast: castOf(0.03, chance)},
    weave: chance.between(0, 0.06),
    defocus: chance.between(0.3, 0.7),
    motion: 0,
    iso: chance.between(20, 100),
    halo: chance.between(0, 0.3),
    quality: chance.whole(90, 95),
    crop: 1,
  };
}

function normal(chance: Chance): Conditions {
  return {
    level: 'normal',
    f35: chance.whole(24, 50),
    tilt: chance.between(0, 12) * degrees,
    axis: chance.between(0, 2 * Math.PI),
    turn: chance.between(0, 2 * Math.PI),
    repeats: chance.between(2.7, 7),
    cellsShown: 2.4,
    lens: chance.between(-0.01, 0.01),
    creases: chance.between(0, 0.005),
    lamps: {
      least: chance.between(0.6, 0.95),
      vignette: chance.between(0, 0.2),
      cast: castOf(0.1, chance),
    },
    weave: chance.between(0, 0.1),
    defocus: chance.between(0.3, 1),
    motion: chance.happens(0.2) ? chance.between(0, 1) : 0,
    iso: chance.between(100, 800),
    halo: chance.between(0, 0.5),
    quality: chance.whole(75, 95),
    crop: 1,
  };
}

function hard(chance: Chance): Conditions {
  return {
    level: 'hard',
    f35: chance.whole(24, 50),
    tilt: chance.between(8, 25) * degrees,
    axis: chance.between(0, 2 * Math.PI),
    turn: chance.between(0, 2 * Math.PI),
    repeats: chance.between(2.7, 8),
    cellsShown: 2.4,
    lens: chance.between(-0.04, 0.04),
    creases: chance.between(0.003, 0.015),
    lamps: {
      least: chance.between(0.35, 0.8),
      vignette: chance.between(0.1, 0.35),
      cast: castOf(0.15, chance),
    },
    weave: chance.between(0, 0.15),
    defocus: chance.between(0.3, 2),
    motion: chance.happens(0.5) ? chance.between(0, 3) : 0,
    iso: chance.between(400, 3200),
    halo: chance.between(0, 0.9),
    quality: chance.whole(60, 90),
    crop: chance.happens(0.25) ? chance.between(0.75, 0.95) : 1,
  };
}

const byLevel = {scan, normal, hard};

export const conditionsOf = (level: PhotoLevel, chance: Chance): Conditions =>
  byLevel[level](chance);
