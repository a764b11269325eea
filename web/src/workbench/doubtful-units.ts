/** A garment whose file names no unit that can be trusted: taken as it is, a person could not wear it. */
import type {Garment} from '../model/garment.js';
import {fieldOf} from '../model/read.js';
import type {MeshedPattern} from '../model/result.js';

/** The tallest piece of a garment for anybody is between a baby's bib and a bridal train. [cm] */
const least = 14;
const most = 260;

/** How many units a metre has. */
const unitsInMetre = {cm: 100, mm: 1000, inch: 100 / 2.54, m: 1} as const;
type FileUnit = keyof typeof unitsInMetre;

/** The tallest piece, if no garment has such a one. [cm] */
export function doubtfulHeight({pieces}: Pick<MeshedPattern, 'pieces'>): number | undefined {
  const heights = pieces.map(({rest}) => {
    const ys = rest.map(([, y]) => y);
    return Math.max(...ys) - Math.min(...ys);
  });
  const tallest = Math.max(...heights);
  return tallest < least || tallest > most ? tallest : undefined;
}

/** Units that would make it a height that somebody could wear. */
export function likelyUnits(text: string, height: number): readonly FileUnit[] {
  const now = written(JSON.parse(text) as Garment);
  return (Object.keys(unitsInMetre) as FileUnit[]).filter((unit) => {
    const taken = (height * now) / unitsInMetre[unit];
    return taken >= least && taken <= most;
  });
}

/** The same file in another unit. */
export function inUnit(text: string, unit: FileUnit): string {
  const garment = JSON.parse(text) as Garment;
  const properties = {
    ...(garment.properties as object | undefined),
    units_in_meter: unitsInMetre[unit],
  };
  return JSON.stringify({...garment, properties});
}

function written({properties}: Garment): number {
  const value = fieldOf(properties, 'units_in_meter');
  return typeof value === 'number' ? value : unitsInMetre.cm;
}
