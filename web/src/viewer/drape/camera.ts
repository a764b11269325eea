/** Camera of a drape. Azimuth 0 shows the front; a quarter turn more shows the wearer's left. */
import {dot3, minus3, unit3, type Box3, type Vector} from './space.js';

/** Named view directions. */
export const presetNames = ['front', 'back', 'left', 'right', 'three-quarter'] as const;
export type CameraPreset = (typeof presetNames)[number];

/** Angles in radians, lengths in cm. */
export interface Orbit {
  readonly azimuth: number;
  /** Angle above the horizon. */
  readonly elevation: number;
  readonly distance: number;
  /** Middle of the picture. */
  readonly target: Vector;
}

/** Vertical field of view. [radians] */
export const fieldOfView = (24 * Math.PI) / 180;
/** Free share of the picture around a fitted box. */
const margin = 0.08;
const steepest = (80 * Math.PI) / 180;
/** Least and greatest distance, as shares of the distance that shows everything. */
const range = [0.12, 2] as const;
/** Turn for one arrow key. [radians] */
export const keyTurn = (15 * Math.PI) / 180;

const degrees = (angle: number): number => (angle * Math.PI) / 180;

const ways: Readonly<Record<CameraPreset, Pick<Orbit, 'azimuth' | 'elevation'>>> = {
  front: {azimuth: 0, elevation: degrees(4)},
  back: {azimuth: Math.PI, elevation: degrees(4)},
  left: {azimuth: Math.PI / 2, elevation: degrees(4)},
  right: {azimuth: -Math.PI / 2, elevation: degrees(4)},
  'three-quarter': {azimuth: degrees(35), elevation: degrees(9)},
};

/** Returns the unit vector from the target to the eye. */
export const wayOut = ({azimuth, elevation}: Pick<Orbit, 'azimuth' | 'elevation'>): Vector => [
  Math.sin(azimuth) * Math.cos(elevation),
  Math.sin(elevation),
  Math.cos(azimuth) * Math.cos(elevation),
];

export function eyeOf(orbit: Orbit): Vector {
  const way = wayOut(orbit);
  return orbit.target.map((value, k) => value + orbit.distance * (way[k] ?? 0)) as [
    number,
    number,
    number,
  ];
}

/** Returns the unit vectors right and up in the picture. */
export function screenAxes({
  azimuth,
  elevation,
}: Pick<Orbit, 'azimuth' | 'elevation'>): readonly [right: Vector, up: Vector] {
  return [
    [Math.cos(azimuth), 0, -Math.sin(azimuth)],
    [
      -Math.sin(azimuth) * Math.sin(elevation),
      Math.cos(elevation),
      -Math.cos(azimuth) * Math.sin(elevation),
    ],
  ];
}

/**
 * Returns the distance at which a picture of this aspect ratio (width / height) shows a whole box
 * around the target.
 */
function fittingDistance(orbit: Omit<Orbit, 'distance'>, box: Box3, aspect: number): number {
  const tangent = Math.tan(fieldOfView / 2) * (1 - margin);
  const [right, up] = screenAxes(orbit);
  const out = wayOut(orbit);
  const distances = cornersOf(box).map((corner) => {
    const from = minus3(corner, orbit.target);
    const aside = Math.max(Math.abs(dot3(from, right)) / aspect, Math.abs(dot3(from, up)));
    return dot3(from, out) + aside / tangent;
  });
  return Math.max(...distances);
}

const cornersOf = ({low, high}: Box3): readonly Vector[] =>
  [low[0], high[0]].flatMap((x) =>
    [low[1], high[1]].flatMap((y) => [low[2], high[2]].map((z): Vector => [x, y, z])),
  );

/** Returns a view of the whole box around the form's axis, from a named direction. */
export function presetOrbit(preset: CameraPreset, box: Box3, aspect: number): Orbit {
  const target: Vector = [0, (box.low[1] + box.high[1]) / 2, (box.low[2] + box.high[2]) / 2];
  const orbit = {...ways[preset], target};
  return {...orbit, distance: fittingDistance(orbit, box, aspect)};
}

/** Turns the camera around the target. [radians] */
export const turned = (orbit: Orbit, azimuth: number, elevation = 0): Orbit => ({
  ...orbit,
  azimuth: withinTurn(orbit.azimuth + azimuth),
  elevation: Math.min(steepest, Math.max(-steepest, orbit.elevation + elevation)),
});

/** @param whole distance that shows everything [cm] */
export const nearer = (orbit: Orbit, factor: number, whole: number): Orbit => ({
  ...orbit,
  distance: Math.min(range[1] * whole, Math.max(range[0] * whole, orbit.distance / factor)),
});

/** Moves the target in the plane of the picture, but not out of a box. [cm] */
export function movedBy(orbit: Orbit, {low, high}: Box3, right: number, up: number): Orbit {
  const [across, upwards] = screenAxes(orbit);
  const target = orbit.target.map((value, k) => {
    const moved = value + right * (across[k] ?? 0) + up * (upwards[k] ?? 0);
    return Math.min(high[k] ?? 0, Math.max(low[k] ?? 0, moved));
  }) as [number, number, number];
  return {...orbit, target};
}

/** Returns the same angle, more than -pi and at most pi. */
function withinTurn(angle: number): number {
  const turn = 2 * Math.PI;
  const rest = angle - turn * Math.floor(angle / turn);
  return rest > Math.PI ? rest - turn : rest;
}

/** Interpolates between two orbits, along the shorter way around. */
export function onTheWay(from: Orbit, to: Orbit, share: number): Orbit {
  const mixed = (a: number, b: number): number => a + share * (b - a);
  return {
    azimuth: withinTurn(from.azimuth + share * withinTurn(to.azimuth - from.azimuth)),
    elevation: mixed(from.elevation, to.elevation),
    distance: mixed(from.distance, to.distance),
    target: from.target.map((value, k) => mixed(value, to.target[k] ?? value)) as [
      number,
      number,
      number,
    ],
  };
}

/** Returns the preset nearest to a view. */
export function nearestPreset(orbit: Pick<Orbit, 'azimuth' | 'elevation'>): CameraPreset {
  const way = unit3(wayOut(orbit));
  const nearness = (name: CameraPreset): number =>
    wayOut(ways[name]).reduce((sum, value, k) => sum + value * (way[k] ?? 0), 0);
  return presetNames.reduce((best, name) => (nearness(name) > nearness(best) ? name : best));
}

/** Turns the camera to face a direction, slightly from above. */
export const facing = (orbit: Orbit, [x, , z]: Vector): Orbit =>
  x === 0 && z === 0
    ? orbit
    : {...orbit, azimuth: Math.atan2(x, z), elevation: ways.front.elevation};
