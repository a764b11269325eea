/** Finds darts: wedges cut into a piece, with two sides of equal length. */
import type {EdgeOfPiece} from '../model/garment/garment-document.js';
import type {Words} from '../model/garment/piece-words.js';
import type {Point} from '../model/geometry/vectors.js';

/** Greatest angle between the two sides. [rad] */
const widest = 1.05;
/** Greatest distance of both sides at the mouth; a deep neckline is wider. [cm] */
const mouth = 9;
/** Greatest difference of log lengths of the two sides. */
const ease = 0.015;
/** Longest side of a dart. [cm] */
const longest = 35;
/** Least rise of the first side of a slit, per cm of its length. */
const upright = 0.4;
/** Greatest angle of an insert at its tip. [rad] */
const insert = 1.4;

/** A measured edge of a garment with open darts. */
interface Outline {
  readonly at: EdgeOfPiece;
  readonly length: number;
  readonly corner: number;
  readonly chord: Point;
  readonly after: number;
  readonly isOpen: boolean;
}
interface Outlines {
  readonly edges: readonly Outline[];
  readonly pieces: readonly {readonly words: Words}[];
}

/** Edge numbers of both sides, in the order of the outline. */
type Dart = readonly [number, number];

/**
 * Returns whether a wedge can be a slit: it begins at the foot of a piece that may end in a hem.
 */
function mayBeSlit({pieces}: Outlines, first: Outline): boolean {
  const kind = pieces[first.at.piece]?.words.kind;
  const limit = kind === 'skirt' || kind === 'trousers' ? -upright : upright;
  return kind !== 'bodice' && kind !== 'sleeve' && first.chord[1] > limit;
}

/** Returns whether another piece has a wedge with sides of the same length, which may be set in. */
const hasInsert = (garment: Outlines, {at, length}: Outline): boolean =>
  garment.edges.some((edge) => {
    const next = garment.edges[edge.after];
    return (
      edge.at.piece !== at.piece &&
      next !== undefined &&
      next.corner < insert &&
      Math.abs(Math.log(edge.length / length)) < ease &&
      Math.abs(Math.log(next.length / length)) < ease
    );
  });

/** Returns the darts that need no question: neither slits nor places of inserts. */
export function dartsOf(garment: Outlines): readonly Dart[] {
  return garment.edges.flatMap((first, number): Dart[] => {
    const second = garment.edges[first.after];
    if (!second || first.isOpen || second.isOpen) return [];
    const angle = 2 * Math.PI - second.corner;
    const isWedge =
      angle < widest &&
      Math.abs(Math.log(first.length / second.length)) < ease &&
      first.length < longest &&
      2 * first.length * Math.sin(angle / 2) < mouth;
    if (!isWedge || mayBeSlit(garment, first) || hasInsert(garment, first)) return [];
    return [[number, first.after]];
  });
}
