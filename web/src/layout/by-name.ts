/**
 * Places of pieces on the body that follow from their names, for files without placements, such as
 * DXF. Lengths in cm.
 */
import {boxOf} from '../model/geometry/polyline.js';
import type {Pattern} from '../model/result/result.js';
import {wordsOf, type PieceKind, type Words} from '../model/garment/piece-words.js';
import type {Placements} from './on-body.js';

/** Kinds from the top down; pieces of one level share a row. */
const levels: Readonly<Record<PieceKind, number>> = {
  ...{hood: 3, collar: 3, bodice: 2, sleeve: 2, pocket: 1.5, band: 1, cuff: 0.5},
  ...{skirt: 0, trousers: 0},
};
/** Distance of two levels, more than any piece is high. */
const step = 400;
/** Distance of pieces on the left and right from the middle, and of front and back. */
const aside = 30;
/** Distance of pieces in the same place, so that they keep their order. */
const apart = 0.01;
/** Least share of the pieces that names must place. */
const most = 0.75;

const isPlacedBy = ({face, side, kind}: Words): boolean =>
  face !== 0 || side !== 0 || kind !== undefined;

/** Returns places by names; undefined if too few names tell one. */
export function placementsByName({pieces}: Pick<Pattern, 'pieces'>): Placements | undefined {
  const words = pieces.map(({name}) => wordsOf(name));
  const faces = new Set(words.map(({face}) => face));
  if (words.filter(isPlacedBy).length < most * pieces.length || !faces.has(1)) return undefined;
  return new Map(
    pieces.map(({name, rest, outline}, k) => {
      const {kind = 'bodice', face = 0, side = 0} = words[k] ?? {};
      const {low, high} = boxOf(outline.flatMap((v) => rest.slice(v, v + 1)));
      const [x, y] = [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2];
      const isSleeve = kind === 'sleeve' || (kind === 'cuff' && side !== 0);
      const z = face < 0 ? -aside : aside;
      // a piece turned to the side belongs to a sleeve
      const turn = isSleeve ? 90 * (side || 1) : 0;
      const up = levels[kind] * step - y;
      const place = isSleeve
        ? ([0, up, x + face + apart * k] as const)
        : ([side * aside + apart * k - x, up, z] as const);
      return [name, {translation: place, rotation: [0, turn, 0]}] as const;
    }),
  );
}
