/** A repeat as a maker measures it, and the lattice that it stands for. */
import type {Point} from './geometry.js';
import type {GroupName} from './print.js';
import {latticeType} from './wallpaper.js';

/**
 * The sides of the cell that a maker would measure: of the rectangular cell when the lattice is rhombic,
 * of the rhombus itself when it is hexagonal. [cm]
 */
export interface RepeatSize {
  readonly width: number;
  readonly height: number;
  /** Between the sides; 90 unless the lattice is oblique. [degrees] */
  readonly angleDeg: number;
}

const radians = (degrees: number): number => (degrees * Math.PI) / 180;

const turned = ([x, y]: Point, angle: number): Point => [
  x * Math.cos(angle) - y * Math.sin(angle),
  x * Math.sin(angle) + y * Math.cos(angle),
];

/** w1, w2 of a group's lattice, the whole print turned counter-clockwise. [cm] */
export function latticeVectors(
  group: GroupName,
  {width, height, angleDeg}: RepeatSize,
  turnDeg = 0,
): readonly [Point, Point] {
  const upright = ((): readonly [Point, Point] => {
    switch (latticeType(group)) {
      case 'rhombic':
        return [
          [width / 2, -height / 2],
          [width / 2, height / 2],
        ];
      case 'hexagonal':
        return [
          [width, 0],
          [width / 2, (width * Math.sqrt(3)) / 2],
        ];
      case 'square':
        return [
          [width, 0],
          [0, width],
        ];
      case 'rectangular':
        return [
          [width, 0],
          [0, height],
        ];
      case 'oblique':
        return [[width, 0], turned([height, 0], radians(angleDeg))];
    }
  })();
  if (turnDeg === 0) return upright;
  const angle = radians(turnDeg);
  return [turned(upright[0], angle), turned(upright[1], angle)];
}
