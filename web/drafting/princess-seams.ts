/** The seam lines of the princess dress: each is drafted once and the panel it is sewn to is trued to it. */
import type {Body} from './body.js';
import {bodiceSeam, skirtSeam, upright} from './fitted-seams.js';
import {curve, degrees, leaning, length, trueTo, type Curve, type Point} from './geometry.js';

/** What the dress is wider than the body, all round. */
const ease = {bust: 7, waist: 5, hip: 7};
/** From the waist to the hem, along the seams. */
export const skirtLength = 58;
export const shoulderSlope = degrees(19);
/** How much further than the hip the hem stands out at each seam. */
const flare = degrees(0.8);
/** The lengths that shape a princess seam: how wide the centre panel is, and how the side panel leans away from it. */
export interface Princess {
  readonly centreWaist: number;
  readonly centreFull: number;
  readonly fullHeight: number;
  /** x of the side panel at the fullest height and at the shoulder, its waist being 0. */
  readonly sideFull: number;
  readonly sideShoulder: number;
  readonly sideSlope: number;
}

/** The three edges of a seam, from the hem up: hem to waist, waist to the fullest height, on to the shoulder. */
export interface SeamLine {
  readonly skirt: Curve;
  readonly waist: Curve;
  readonly top: Curve;
}

/** What every edge below the waist leans out by so that the three of a quarter make the hip. */
function hipLean(body: Body): number {
  const wider = (body.hip + ease.hip - body.waist - ease.waist) / 4;
  return Math.atan(wider / 3 / body.hipDepth) + flare;
}

export function centreLine(body: Body, princess: Princess, shoulderPoint: Point): SeamLine {
  const waist: Point = [princess.centreWaist, 0];
  const full: Point = [princess.centreFull, princess.fullHeight];
  return {
    skirt: skirtSeam('the princess seam', waist, hipLean(body), skirtLength),
    waist: bodiceSeam(waist, full),
    top: curve(full, upright, shoulderPoint, leaning(shoulderSlope)),
  };
}

/** The side panel's edge of the seam: another shape, every part trued to the length it is sewn to. */
export function sideLine(body: Body, princess: Princess, centre: SeamLine): SeamLine {
  const waist: Point = [0, 0];
  const waistAt = (height: number): Curve => bodiceSeam(waist, [princess.sideFull, height]);
  const lower = waistAt(
    trueTo(
      'the princess seam below the bust',
      length(centre.waist),
      (y) => length(waistAt(y)),
      5,
      30,
    ),
  );
  const topAt = (rise: number): Curve =>
    curve(
      lower.to,
      upright,
      [princess.sideShoulder, lower.to[1] + rise],
      leaning(princess.sideSlope),
    );
  const top = topAt(
    trueTo('the princess seam above the bust', length(centre.top), (y) => length(topAt(y)), 5, 45),
  );
  return {
    skirt: skirtSeam('the side panel', waist, -hipLean(body), length(centre.skirt)),
    waist: lower,
    top,
  };
}

/** The side seam of a side panel, for its waist at the origin; one line for front and back. */
export interface SideSeam {
  readonly skirt: Curve;
  /** From the waist up to the dart. */
  readonly waist: Curve;
  /** The direction it goes on in, and for how long: up to the underarm. */
  readonly lean: Point;
  readonly upper: number;
}

export function sideSeam(body: Body): SideSeam {
  const lean = leaning(degrees(7));
  const dartHeight = body.backLength * 0.29;
  const underarm = body.backLength - (body.bust / 10 + 12);
  // what the princess seams do not add from waist to bust is shared by the two side panels
  const gain = (princess: Princess): number =>
    princess.centreFull - princess.centreWaist - princess.sideFull;
  const wider = (body.bust + ease.bust - body.waist - ease.waist) / 2;
  const out = (wider - gain(frontPrincess(body)) - gain(backPrincess(body))) / 2;
  return {
    skirt: skirtSeam('the side seam', [0, 0], hipLean(body), skirtLength),
    waist: bodiceSeam([0, 0], [out, dartHeight], lean),
    lean,
    upper: underarm - dartHeight,
  };
}

/** A quarter of the body: what the centre panel leaves is the side panel's. */
export function sidePanelWaist(body: Body, princess: Princess): number {
  return (body.waist + ease.waist) / 4 - princess.centreWaist;
}

export function frontPrincess(body: Body): Princess {
  return {
    centreWaist: body.waist * 0.095,
    centreFull: body.bust * 0.1,
    fullHeight: body.backLength * 0.41,
    sideFull: -1.6,
    sideShoulder: 3.4,
    sideSlope: degrees(24),
  };
}

export function backPrincess(body: Body): Princess {
  return {
    centreWaist: body.waist * 0.1,
    centreFull: body.bust * 0.102,
    fullHeight: body.backLength * 0.5,
    sideFull: -0.9,
    sideShoulder: 1.8,
    sideSlope: degrees(21),
  };
}
