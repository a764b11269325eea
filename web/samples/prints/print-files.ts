/** The files of each print in the collection: its description, and a tile in every colourway. */
import type {Colourway, Print} from '../../src/model/print/repeating-print.js';
import {printElements} from '../../src/model/print/wallpaper.js';
import type {Design} from './design.js';
import {palettes, type PaletteName} from './palette.js';
import {imageSize, tileFile, type Cell} from './tile.js';

/** The density of the raster tiles. [px per cm] */
const density = {least: 28, usual: 32, most: 36};

/** Pixels of the vector tiles for each pixel of the raster tiles. */
const vectorScale = 3;

/**
 * The integer numbers of pixels near the usual density that are closest to the cell's proportions.
 */
export function pixelsOf(cell: Cell): readonly [width: number, height: number] {
  const [width, height] = imageSize(cell);
  const usual = Math.round(width * density.usual);
  const near = Array.from({length: Math.ceil(width * density.most) + 1}, (_, across) => across)
    .filter((across) => across >= width * density.least)
    .map((across): [number, number] => [across, Math.round((across * height) / width)])
    .sort(([a], [b]) => Math.abs(a - usual) - Math.abs(b - usual));
  const error = ([a, b]: readonly [number, number]): number =>
    Math.abs((b * width) / (a * height) - 1);
  return near.reduce((best, one) => (error(one) < error(best) - 1e-9 ? one : best));
}

/** Returns whether fabric turned by 180 degrees shows another print. */
const hasUpside = (cell: Cell): boolean =>
  !printElements(cell).some(({xx, yy, xy}) => xx < 0 && yy < 0 && Math.abs(xy) < 1e-9);

const capital = (name: string): string => name.charAt(0).toUpperCase() + name.slice(1);

/** The name of a tile's files, without extension; the first colourway has the name of the print. */
const tileName = ({id, colourways}: Design, name: PaletteName): string =>
  name === colourways[0] ? id : `${id}-${name}`;

export function printOf(design: Design): Print {
  const {cell, title, family} = design;
  const colourways = design.colourways.map((name): Colourway => {
    const file = tileName(design, name);
    return {name: capital(name), image: `${file}.svg`, raster: `${file}.png`};
  });
  return {
    format: 'seamwise-print/1',
    title,
    family,
    ...cell,
    image: `${design.id}.svg`,
    oneWay: hasUpside(cell),
    fabric: {usableWidthCm: 140},
    colourways,
  };
}

/** The text of a print file, one field a line. */
export function printFile(design: Design): string {
  const {format, title, family, group, w1, w2, image, cell, oneWay, fabric, colourways} =
    printOf(design);
  const fields = {format, title, family, group, w1, w2, image, cell, oneWay, fabric, colourways};
  const lines = Object.entries(fields).map(
    ([key, value]) => `  ${JSON.stringify(key)}: ${JSON.stringify(value)}`,
  );
  return `{\n${lines.join(',\n')}\n}\n`;
}

interface TileFiles {
  /** File name without its extension. */
  readonly name: string;
  readonly palette: PaletteName;
  readonly svg: string;
  readonly pixels: readonly [width: number, height: number];
}

/** The tiles of a print, one for each colourway. */
export function tilesOf(design: Design): readonly TileFiles[] {
  const pixels = pixelsOf(design.cell);
  const size = [pixels[0] * vectorScale, pixels[1] * vectorScale] as const;
  return design.colourways.map((palette) => ({
    name: tileName(design, palette),
    palette,
    svg: tileFile(design.cell, size, design.draw(palettes[palette])),
    pixels,
  }));
}
