/** A designer's description of a print: its group, its lattice, its colourways and its motifs. */
import type {Point} from '../../src/model/geometry/vectors.js';
import type {GroupName, Print} from '../../src/model/print/repeating-print.js';
import {latticeType} from '../../src/model/print/wallpaper.js';
import type {Palette, PaletteName} from './palette.js';
import {grown, type Motif} from './shape.js';
import {groundOf, printed, type Cell} from './tile.js';

type Family = NonNullable<Print['family']>;

/** The three colourways of a print; the first is its main one. */
export type Colourways = readonly [PaletteName, PaletteName, PaletteName];

export interface Design {
  /** The name of its files. */
  readonly id: string;
  readonly title: string;
  readonly family: Family;
  readonly cell: Cell;
  readonly colourways: Colourways;
  /** Contents of one cell: elements of an SVG file, in cm, y down. */
  readonly draw: (palette: Palette) => string[];
}

export type Lattice = readonly [Point, Point];

export const upright = (width: number, height: number): Lattice => [
  [width, 0],
  [0, height],
];
/** A lattice with w1 along the warp. */
export const warpwise = (along: number, across: number): Lattice => [
  [0, along],
  [-across, 0],
];
/** A lattice without a right angle. */
export const slanted = (w1: Point, w2: Point): Lattice => [w1, w2];
export const square = (side: number): Lattice => upright(side, side);
export const hexagonal = (side: number): Lattice => [
  [side, 0],
  [side / 2, (side * Math.sqrt(3)) / 2],
];
export const hexagonalWarpwise = (side: number): Lattice => [
  [0, side],
  [(-side * Math.sqrt(3)) / 2, side / 2],
];
/** A lattice with w1 + w2 upright: the mirror lines of cm run along the warp. */
export const rhombic = (width: number, height: number): Lattice => [
  [width / 2, height / 2],
  [-width / 2, height / 2],
];
export const rhombicLevel = (width: number, height: number): Lattice => [
  [width / 2, -height / 2],
  [width / 2, height / 2],
];

/** The motif at its place on the print: its foot [cm], its heading and its size. */
export const place = (motif: Motif, x: number, y: number, heading = 0, size = 1): Motif =>
  grown(motif, [x, y], heading, size);

export function cellOf(group: GroupName, [w1, w2]: Lattice): Cell {
  const centred = ['rhombic', 'hexagonal'].includes(latticeType(group));
  return {group, w1, w2, cell: centred ? 'rectangular' : 'primitive'};
}

const motifPrint =
  (family: Family) =>
  (
    id: string,
    title: string,
    colourways: Colourways,
    group: GroupName,
    lattice: Lattice,
    motifs: readonly Motif[],
  ): Design => {
    const cell = cellOf(group, lattice);
    return {
      id,
      title,
      family,
      cell,
      colourways,
      draw: (palette) => [groundOf(palette), ...printed(cell, motifs, palette)],
    };
  };

export const botanical = motifPrint('botanical');
export const geometric = motifPrint('geometric');
export const tailored = motifPrint('tailored');
