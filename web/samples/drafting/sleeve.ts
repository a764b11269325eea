/**
 * Set-in sleeves, drafted for the wearer's left, with the front half at -x. Origin: on the line
 * across both underarms, below the top of the cap.
 */
import {leftOf, plus, radians, type Point} from '../../src/model/geometry/vectors.js';
import type {Body} from './body.js';
import type {BodiceHalf, Half} from './bodice.js';
import {
  curve,
  handleFor,
  leaning,
  length,
  line,
  mirror,
  mirrored,
  reversed,
  trueTo,
  type Curve,
} from './curves.js';
import type {Placement} from './panel.js';

interface CapStyle {
  /** Width across the sleeve at the underarm. [cm] */
  readonly width: number;
  /** Excess of each half of the cap over its armhole, as drafted. [cm] */
  readonly ease: Readonly<Record<Half, number>>;
  /** Inward angle of the underarm seams towards the wrist. [radians] */
  readonly taper: number;
}

/** The two curves of a cap, in the order of the outline: up the back, down the front. */
export interface Cap {
  readonly back: Curve;
  readonly front: Curve;
  readonly height: number;
}

/** Handles at the underarm, as parts of the half width: the front of a cap curves in further. */
const scoop = {front: 0.5, back: 0.34};
/**
 * Handle at the top of a cap with equal halves, as a part of the half width: the roundness of the
 * top.
 */
const roundness = 0.57;

/** Least height of a cap. [cm] */
const lowestCap = 6;

/**
 * Half a cap on its +x side; both halves share the curvature at the top, so that it has no point.
 */
function capHalf(half: Half, style: CapStyle, width: number, height: number): Curve {
  const atUnderarm = scoop[half] * width;
  const curvature = (2 * height) / (3 * ((roundness * style.width) / 2) ** 2);
  const out = leftOf(leaning(style.taper));
  const atTop = handleFor(curvature, height - atUnderarm * out[1]);
  return curve([width, 0], out, [0, height], [-1, 0], atUnderarm, atTop);
}

/**
 * The cap for a pair of armholes: a lower cap is wider, so its height follows from the width of the
 * sleeve.
 */
export function sleeveCap(armholes: Readonly<Record<Half, number>>, style: CapStyle): Cap {
  const goal = (half: Half): number => armholes[half] + style.ease[half];
  const narrowest = 0.3 * style.width;
  const widthAt = (half: Half, height: number): number =>
    trueTo(
      `the ${half} sleeve cap`,
      goal(half),
      (w) => length(capHalf(half, style, w, height)),
      narrowest,
      0.85 * style.width,
    );
  const highest = (half: Half): number =>
    trueTo(
      'the sleeve cap',
      goal(half),
      (h) => length(capHalf(half, style, narrowest, h)),
      lowestCap,
      goal(half),
    );
  const height = trueTo(
    'the sleeve width',
    style.width,
    (h) => widthAt('front', h) + widthAt('back', h),
    lowestCap,
    Math.min(highest('front'), highest('back')) - 1e-6,
  );
  return {
    back: capHalf('back', style, widthAt('back', height), height),
    front: reversed(mirrored(capHalf('front', style, widthAt('front', height), height))),
    height,
  };
}

export const armholeLengths = (
  halves: Readonly<Record<Half, BodiceHalf>>,
): Record<Half, number> => ({
  front: length(halves.front.armhole),
  back: length(halves.back.armhole),
});

/** The part of a sleeve below its cap. */
export interface Tube {
  /**
   * The hem from front to back, square to both edges of the underarm seam; concave, since the
   * sleeve narrows.
   */
  readonly hem: Curve;
  readonly underarmBack: Curve;
  readonly underarmFront: Curve;
}

/** @param seamLength  of the underarm seam, in cm */
export function sleeveTube(cap: Cap, taper: number, seamLength: number): Tube {
  const down: Point = plus([0, 0], leaning(taper), -seamLength);
  const hemBack = plus(cap.back.from, down);
  const hemFront = plus(cap.front.to, mirror(down));
  const square = leftOf(leaning(taper));
  return {
    hem: curve(hemFront, mirror(square), hemBack, plus([0, 0], square, -1)),
    underarmBack: line(hemBack, cap.back.from),
    underarmFront: line(cap.front.to, hemFront),
  };
}

interface LongSleeve {
  readonly cap: Cap;
  readonly tube: Tube;
  /** Inward angle of the underarm seams towards the wrist. [radians] */
  readonly taper: number;
}

/**
 * A sleeve with the taper that gives its hem the required length.
 * @param sleeveLength  from the top of the cap to the hem, in cm
 */
export function taperedSleeve(
  armholes: Readonly<Record<Half, number>>,
  style: Omit<CapStyle, 'taper'>,
  sleeveLength: number,
  hemLength: number,
): LongSleeve {
  const drafted = (taper: number): LongSleeve => {
    const cap = sleeveCap(armholes, {...style, taper});
    return {
      cap,
      tube: sleeveTube(cap, taper, (sleeveLength - cap.height) / Math.cos(taper)),
      taper,
    };
  };
  return drafted(
    trueTo(
      'the sleeve at the wrist',
      hemLength,
      (taper) => length(drafted(taper).tube.hem),
      0,
      radians(16),
    ),
  );
}

/** Angle between sleeves and body. */
const hang = radians(45);
const clear = 6;

/**
 * Placement of the left sleeve: its cap slightly outside the shoulder, its front towards +z.
 * @param below  distance of the panel's origin below the draft's, along the sleeve
 */
export function hungSleeve(body: Body, tip: Point, height: number, below = 0): Placement {
  const reach = height + below;
  return {
    translation: [
      tip[0] + clear + reach * Math.sin(hang),
      body.waistHeight + tip[1] + clear - reach * Math.cos(hang),
      0,
    ],
    rotation: [0, 90, 45],
  };
}
