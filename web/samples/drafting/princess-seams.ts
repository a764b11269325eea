/**
 * The seam lines of the princess dress: each is drafted once, and the panel sewn to it is trued to
 * it.
 */
import {minus, plus, radians, rotated, type Point} from '../../src/model/geometry/vectors.js';
import type {Body} from './body.js';
import {bodiceSeam, skirtSeam, upright} from './fitted-seams.js';
import {curve, leaning, length, mirrored, moved, splitWhere, trueTo, type Curve} from './curves.js';

/** Excess of the dress over the body, all round. */
const ease = {bust: 5, waist: 4, hip: 5};
/** Length from the waist to the hem, along the seams. */
const skirtLength = 58;
/** Outward angle of each seam at the hem. */
const flare = radians(3.5);
const sideLean = radians(4);
export const shoulderSlope = radians(19);
/** Intake of the centre back seam at the waist, on each side. */
export const centreTaken = 1.2;

/**
 * The measures that shape a princess seam, on the centre panel and on the side panel. [cm, radians]
 */
interface Princess {
  /** x of the centre panel's edge at the waist and at the fullest height, and that height. */
  readonly centreWaist: number;
  readonly centreFull: number;
  readonly fullHeight: number;
  /** Outward shift of the side panel's edge from the waist to the fullest height. */
  readonly sideOut: number;
  /**
   * Angle of the side panel away from the centre panel above that height: the seam's intake for
   * bust or shoulder blade.
   */
  readonly dart: number;
}

export type Half = 'front' | 'back';

function princessOf(body: Body, half: Half): Princess {
  return half === 'front'
    ? {
        centreWaist: body.waist * 0.1,
        centreFull: body.bust * 0.1,
        fullHeight: body.backLength * 0.41,
        sideOut: 1.8,
        dart: radians(7),
      }
    : {
        centreWaist: body.waist * 0.105,
        centreFull: body.bust * 0.102,
        fullHeight: body.backLength * 0.5,
        sideOut: 1,
        dart: radians(4),
      };
}

/** The slope of the shoulder on the flat side panel. */
export const sideSlope = (body: Body, half: Half): number =>
  shoulderSlope + princessOf(body, half).dart;

/**
 * The three edges of a seam, from the hem up: hem to waist, waist to the fullest height, on to the
 * shoulder.
 */
interface SeamLine {
  readonly skirt: Curve;
  readonly waist: Curve;
  readonly top: Curve;
}

/**
 * An edge below a waist at the origin: with the centre back, which is straight there, all twelve
 * make the hip.
 */
function skirtOf(body: Body): Curve {
  const wider = (body.hip + ease.hip - body.waist - ease.waist) / 2;
  return skirtSeam('the skirt', {
    atHip: (wider - centreTaken) / 6,
    hipDepth: body.hipDepth,
    flare,
    seamLength: skirtLength,
  });
}

/**
 * The centre back below the waist: it is back in the middle at the hip, and flares like the other
 * seams.
 */
export function centreBackSkirt(body: Body): Curve {
  const seam = skirtSeam('the centre back', {
    atHip: centreTaken,
    hipDepth: body.hipDepth,
    flare: flare / 2,
    seamLength: skirtLength,
  });
  return moved(mirrored(seam), [centreTaken, 0]);
}

/** The centre panel's edge, at its +x side. */
export function centreLine(body: Body, half: Half, shoulderPoint: Point): SeamLine {
  const {centreWaist, centreFull, fullHeight} = princessOf(body, half);
  const full: Point = [centreFull, fullHeight];
  return {
    skirt: moved(skirtOf(body), [centreWaist, 0]),
    waist: bodiceSeam([centreWaist, 0], full),
    top: curve(full, upright, shoulderPoint, leaning(shoulderSlope)),
  };
}

/**
 * The side panel's edge of the seam, for a waist at the origin: another shape, trued part by part.
 */
export function sideLine(body: Body, half: Half, centre: SeamLine): SeamLine {
  const {sideOut, dart} = princessOf(body, half);
  const waistAt = (height: number): Curve => bodiceSeam([0, 0], [-sideOut, height]);
  const waist = waistAt(
    trueTo(
      'the princess seam below the bust',
      length(centre.waist),
      (y) => length(waistAt(y)),
      5,
      30,
    ),
  );
  const away = rotated(minus(centre.top.to, centre.top.from), -dart);
  const topAt = (share: number): Curve =>
    curve(waist.to, upright, plus(waist.to, away, share), leaning(shoulderSlope + dart));
  const top = topAt(
    trueTo(
      'the princess seam above the bust',
      length(centre.top),
      (share) => length(topAt(share)),
      0.8,
      1.2,
    ),
  );
  return {skirt: mirrored(skirtOf(body)), waist, top};
}

/** The side seam of a side panel, for its waist at the origin; one line for front and back. */
interface SideSeam {
  readonly skirt: Curve;
  /** Parts from the waist up to the bust dart, and on to the underarm. */
  readonly lower: Curve;
  readonly upper: Curve;
}

export function sideSeam(body: Body): SideSeam {
  const underarm = body.backLength - (body.bust / 10 + 12);
  // the two side panels share the width from waist to bust that the princess seams and the centre
  // back do not add
  const gain = ({centreFull, centreWaist, sideOut}: Princess): number =>
    centreFull - centreWaist + sideOut;
  const added = gain(princessOf(body, 'front')) + gain(princessOf(body, 'back')) + centreTaken;
  const wider = (body.bust + ease.bust - body.waist - ease.waist) / 2;
  const bodice = bodiceSeam([0, 0], [(wider - added) / 2, underarm], leaning(sideLean));
  const dartHeight = 0.3 * body.backLength;
  const [lower, upper] = splitWhere('the bust dart', bodice, ([, y]) => y, dartHeight);
  return {skirt: skirtOf(body), lower, upper};
}

/** Waist of a side panel: a quarter of the body less the centre panel. */
export function sidePanelWaist(body: Body, half: Half): number {
  const centre = princessOf(body, half).centreWaist - (half === 'back' ? centreTaken : 0);
  return (body.waist + ease.waist) / 4 - centre;
}
