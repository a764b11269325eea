/** Objects on photographed fabric, and seams and folds in it, that take the print's regularity. */
import type {Chance} from './chance.js';
import {inkOf, type Ink} from './inks.js';
import {disc, placed, type Outline} from './outlines.js';

/**
 * Something on the fabric. Places are relative to the image's middle, in halves of its longer side,
 * x to the right and y down as far as the image is not tilted.
 */
export interface Cover {
  /** True where the print is hidden or displaced. */
  readonly hides: (x: number, y: number) => boolean;
  /** Changes the fabric's colour at a place, in linear light. */
  readonly paint: (x: number, y: number, colour: Float32Array) => void;
  /** Displacement of the print at a place, in lattice coordinates. */
  readonly displaced?: (x: number, y: number) => readonly [number, number];
}

type Outside = Outline['outside'];

const nearest =
  (parts: readonly Outside[]): Outside =>
  (x, y) =>
    Math.min(...parts.map((part) => part(x, y)));

/** A bar with round ends from (x0, y0) to (x1, y1). */
const bar =
  (x0: number, y0: number, x1: number, y1: number, radius: number): Outside =>
  (x, y) => {
    const [dx, dy] = [x1 - x0, y1 - y0];
    const along = ((x - x0) * dx + (y - y0) * dy) / (dx * dx + dy * dy);
    const t = Math.min(1, Math.max(0, along));
    return Math.hypot(x - x0 - t * dx, y - y0 - t * dy) - radius;
  };

const mix = (colour: Float32Array, ink: Ink, share: number): void => {
  for (let c = 0; c < 3; c++) colour[c] = (1 - share) * (colour[c] ?? 0) + share * (ink[c] ?? 0);
};

/** An opaque object with a soft contact shadow. */
function solid(
  outside: Outside,
  inkAt: (x: number, y: number) => Ink,
  shadow: {readonly depth: number; readonly width: number},
): Cover {
  return {
    hides: (x, y) => outside(x, y) < 0,
    paint: (x, y, colour) => {
      const d = outside(x, y);
      if (d < 0) mix(colour, inkAt(x, y), 1);
      else if (d < 4 * shadow.width)
        mix(colour, [0, 0, 0], shadow.depth * Math.exp(-d / shadow.width));
    },
  };
}

const shadowOf = (chance: Chance) => ({
  depth: chance.between(0, 0.5),
  width: chance.between(0.005, 0.02),
});

const turned = (turn: number, atX: number, atY: number) => {
  const [c, s] = [Math.cos(turn), Math.sin(turn)];
  return (x: number, y: number): readonly [number, number] => [
    c * (x - atX) + s * (y - atY),
    c * (y - atY) - s * (x - atX),
  ];
};

/** Random letters of 4 x 5 dots. */
const lettersOf = (chance: Chance): readonly (readonly boolean[])[] =>
  Array.from({length: 24}, () => Array.from({length: 20}, () => chance.happens(0.55)));

/** Lines of letters from x = 0 to the right, y = 0 downwards, with dots of a size. */
function inked(dot: number, lines: number, chance: Chance): (x: number, y: number) => boolean {
  const letters = lettersOf(chance);
  const order = Array.from({length: 400}, () => chance.whole(-4, letters.length - 1));
  return (x, y) => {
    const [column, row] = [Math.floor(x / dot), Math.floor(y / dot)];
    const line = Math.floor(row / 8);
    if (line < 0 || line >= lines || column < 0) return false;
    const letter = letters[order[(Math.floor(column / 5) + 97 * line) % order.length] ?? -1];
    const inRow = row - 8 * line;
    return (
      letter !== undefined &&
      inRow < 5 &&
      column % 5 < 4 &&
      letter[4 * inRow + (column % 5)] === true
    );
  };
}

/** A tape measure with ticks and numbers across the whole image. */
function tape(chance: Chance): Cover {
  const at = turned(
    chance.between(0, Math.PI),
    chance.between(-0.4, 0.4),
    chance.between(-0.3, 0.3),
  );
  const width = chance.between(0.03, 0.1);
  const ground = chance.of<Ink>([
    [0.8, 0.8, 0.78],
    [0.85, 0.62, 0.08],
    [0.75, 0.7, 0.3],
  ]);
  const centimetre = width * chance.between(0.8, 1.3);
  const number = inked(width / 12, 1, chance);
  return solid(
    (x, y) => Math.abs(at(x, y)[1]) - width / 2,
    (x, y) => {
      const [along, across] = at(x, y);
      const inTick = (period: number, from: number): boolean =>
        Math.abs(along - period * Math.round(along / period)) < 0.02 * centimetre + 0.03 * period &&
        across > from * width;
      const isInk =
        inTick(centimetre, 0.1) ||
        inTick(centimetre / 10, 0.35) ||
        number(along + 3, across + 0.4 * width);
      return isInk ? [0.02, 0.02, 0.02] : ground;
    },
    shadowOf(chance),
  );
}

/** Letters over the image, dark, light or half transparent. */
function lettering(dot: number, lines: number, opacity: number, chance: Chance): Cover {
  const at = turned(chance.between(-0.6, 0.6), -1.2, chance.between(-0.5, 0.5));
  const is = inked(dot, lines, chance);
  const ink: Ink = chance.happens(0.5) ? [0.9, 0.9, 0.9] : [0.02, 0.02, 0.03];
  return {
    hides: (x, y) => is(...at(x, y)),
    paint: (x, y, colour) => {
      if (is(...at(x, y))) mix(colour, ink, opacity);
    },
  };
}

const text = (chance: Chance): Cover =>
  lettering(chance.between(0.008, 0.018), chance.whole(1, 3), 1, chance);
const watermark = (chance: Chance): Cover =>
  lettering(chance.between(0.03, 0.06), 1, chance.between(0.3, 0.6), chance);

function whiteCard(chance: Chance): Cover {
  const at = turned(
    chance.between(0, Math.PI),
    chance.between(-0.6, 0.6),
    chance.between(-0.4, 0.4),
  );
  const [width, height] = [chance.between(0.25, 0.6), chance.between(0.2, 0.45)];
  return solid(
    (x, y) => {
      const [along, across] = at(x, y);
      return Math.max(Math.abs(along) - width, Math.abs(across) - height);
    },
    () => [0.85, 0.85, 0.83],
    shadowOf(chance),
  );
}

/** An arm from the border, a palm and five fingers. */
function hand(chance: Chance): Cover {
  const size = chance.between(0.6, 1.05);
  const at = turned(
    chance.between(0, 2 * Math.PI),
    chance.between(-0.35, 0.35),
    chance.between(-0.3, 0.3),
  );
  const fingers = Array.from({length: 4}, (_, k) => {
    const lean = (k - 1.5) * 0.14 + chance.between(-0.04, 0.04);
    const length = 0.4 + 0.05 * (1.5 - Math.abs(k - 1.5));
    const root = (k - 1.5) * 0.085;
    return bar(0.12, root, 0.12 + length * Math.cos(lean), root + length * Math.sin(lean), 0.045);
  });
  const outside = nearest([
    bar(-2, 0, -0.1, 0, 0.12),
    bar(-0.05, -0.04, 0.08, 0.02, 0.17),
    bar(-0.05, 0.12, 0.15, 0.32, 0.05),
    ...fingers,
  ]);
  const skin = inkOf(0.06, chance.between(0.3, 0.55), chance.between(0.25, 0.8));
  return solid(
    (x, y) => {
      const [along, across] = at(x, y);
      return size * outside(along / size, across / size);
    },
    (x, y) => {
      const [along, across] = at(x, y);
      const light = 0.85 + 0.15 * Math.cos((9 * across) / size + (2 * along) / size);
      return [skin[0] * light, skin[1] * light, skin[2] * light];
    },
    shadowOf(chance),
  );
}

function scissors(chance: Chance): Cover {
  const size = chance.between(0.7, 1.2);
  const at = turned(
    chance.between(0, 2 * Math.PI),
    chance.between(-0.3, 0.3),
    chance.between(-0.2, 0.2),
  );
  const open = chance.between(0.06, 0.25);
  const blades = nearest([-1, 1].map((side) => bar(-0.05, 0, 0.75, side * open, 0.035)));
  const ring = (side: number): Outside => {
    const {outside} = placed(disc(0.13), -0.45, side * 0.17, 0);
    return (x, y) => Math.abs(outside(x, y)) - 0.035;
  };
  const handles = nearest([
    ...[-1, 1].map(ring),
    ...[-1, 1].map((side) => bar(-0.05, 0, -0.34, side * 0.12, 0.035)),
  ]);
  const plastic = inkOf(chance.next(), chance.between(0.5, 0.9), chance.between(0.1, 0.8));
  const scaled = (x: number, y: number): readonly [number, number] => {
    const [along, across] = at(x, y);
    return [along / size, across / size];
  };
  return solid(
    (x, y) => size * Math.min(blades(...scaled(x, y)), handles(...scaled(x, y))),
    (x, y) => {
      const steel = 0.35 + 0.3 * Math.sin(14 * scaled(x, y)[1]);
      return handles(...scaled(x, y)) < blades(...scaled(x, y)) ? plastic : [steel, steel, steel];
    },
    shadowOf(chance),
  );
}

/** A line across the image beyond which the print is displaced. */
function shiftedBeyond(
  chance: Chance,
  paint: (beyond: number, along: number, colour: Float32Array) => void,
): Cover {
  const turn = chance.between(0, 2 * Math.PI);
  const away = chance.between(0.3, 0.6);
  const at = turned(turn, away * Math.cos(turn), away * Math.sin(turn));
  const shift = [chance.next(), chance.between(0.15, 0.85)] as const;
  return {
    hides: (x, y) => at(x, y)[0] > 0,
    paint: (x, y, colour) => {
      paint(...at(x, y), colour);
    },
    displaced: (x, y) => (at(x, y)[0] > 0 ? shift : [0, 0]),
  };
}

/** Two panels of the fabric, sewn together. */
const seam = (chance: Chance): Cover => {
  const depth = chance.between(0.3, 0.7);
  return shiftedBeyond(chance, (beyond, _, colour) => {
    mix(colour, [0, 0, 0], depth * Math.exp(-Math.abs(beyond) / 0.008));
  });
};

/** A fold that hides a strip of the fabric, with a lit and a dark side. */
const fold = (chance: Chance): Cover => {
  const width = chance.between(0.03, 0.08);
  const depth = chance.between(0.2, 0.6);
  return shiftedBeyond(chance, (beyond, _, colour) => {
    const t = beyond / width;
    if (t < 0) mix(colour, [0, 0, 0], depth * Math.exp(2 * t));
    else mix(colour, [1, 1, 1], 0.3 * depth * Math.exp(-2 * t));
  });
};

export const covers: Readonly<Record<string, (chance: Chance) => Cover>> = {
  tape,
  text,
  watermark,
  card: whiteCard,
  hand,
  scissors,
  seam,
  fold,
};
