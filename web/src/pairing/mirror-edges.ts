/** Finds the mirror image of each edge, on the same piece or on its twin. */
import type {MeasuredEdge, MeasuredGarment, MeasuredPiece} from './edges.js';

/** Greatest difference from a mirror image, as a share of a length or as an angle. [rad] */
const most = 0.06;

/**
 * Returns the difference of one edge from the mirror image of another. Corners are compared
 * crosswise, since the mirror image swaps ends.
 */
function unlikeness(garment: MeasuredGarment, a: MeasuredEdge, b: MeasuredEdge): number {
  const end = garment.edges[b.after]?.corner ?? 0;
  const bend = a.profile.map((heading, k) => heading + (b.profile.at(-1 - k) ?? 0));
  return Math.max(
    Math.abs(Math.log(a.length / b.length)),
    Math.abs(a.corner - end) / 2,
    ...bend.map((angle) => Math.abs(angle) / 2),
  );
}

interface Folding {
  /** Images, in the order of the first piece's edges. */
  readonly images: readonly number[];
  readonly unlikeness: number;
  /**
   * Deviation from a mirror image about the grain; decides between several that the outline allows.
   */
  readonly tilt: number;
}

/** Distance of two edges' middles from a mirrored pair about the grain. */
const tiltOf = ({place: [ax, ay]}: MeasuredEdge, {place: [bx, by]}: MeasuredEdge): number =>
  Math.abs(ax + bx) + Math.abs(ay - by);

function foldingAt(
  garment: MeasuredGarment,
  a: MeasuredPiece,
  b: MeasuredPiece,
  shift: number,
): Folding | undefined {
  let [worst, tilt] = [0, 0];
  const images: number[] = [];
  for (let k = 0; k < a.count; k++) {
    const image = b.first + ((shift + a.count - k) % a.count);
    const [one, other] = [garment.edges[a.first + k], garment.edges[image]];
    if (!one || !other) return undefined;
    worst = Math.max(worst, unlikeness(garment, one, other));
    if (worst > most) return undefined;
    tilt += tiltOf(one, other);
    images.push(image);
  }
  return {images, unlikeness: worst, tilt};
}

/** Returns the best mirroring of one piece onto another; undefined if none fits. */
function foldingOf(
  garment: MeasuredGarment,
  a: MeasuredPiece,
  b: MeasuredPiece,
): Folding | undefined {
  if (a.count !== b.count || Math.abs(Math.log(a.area / b.area)) > most) return undefined;
  const all = Array.from({length: a.count}, (_, shift) => foldingAt(garment, a, b, shift));
  return all.reduce(
    (best, one) => (one && (!best || rankOf(one) < rankOf(best)) ? one : best),
    undefined,
  );
}

/**
 * Least share of an outline that needs an image if the rest differs, such as the darts of a back
 * that closes on one side.
 */
const leastPart = 0.5;

/**
 * Returns the longest part of an outline with a mirror image; images are -1 outside it. Serves
 * pieces that are no mirror images as a whole.
 */
function partlyFolded(
  {edges}: MeasuredGarment,
  a: MeasuredPiece,
  b: MeasuredPiece,
  isImage: (one: number, other: number) => boolean,
): readonly number[] | undefined {
  let [longest, images]: [number, readonly number[]] = [leastPart, []];
  for (let from = 0; from < a.count; from++) {
    for (let to = 0; to < b.count; to++) {
      const own = new Array<number>(a.count).fill(-1);
      let share = 0;
      for (let k = 0; k < Math.min(a.count, b.count); k++) {
        const one = (from + k) % a.count;
        const other = b.first + ((to + b.count - k) % b.count);
        if (!isImage(a.first + one, other)) break;
        own[one] = other;
        share += edges[a.first + one]?.share ?? 0;
      }
      // sums in another order differ by rounding
      if (share > longest + 1e-6) [longest, images] = [share, own];
    }
  }
  return images.length > 0 ? images : undefined;
}

const rankOf = ({unlikeness, tilt}: Folding): number => unlikeness + 0.01 * tilt;

/** Returns whether the names allow two pieces, or one with itself, to be mirror images. */
function mayMirror(a: MeasuredPiece, b: MeasuredPiece): boolean {
  const [one, other] = [a.words, b.words];
  return (
    one.side === (-other.side as typeof one.side) &&
    one.face === other.face &&
    one.isSleeve === other.isSleeve
  );
}

/** Keeps only mutual images. */
const mutual = (images: Int32Array): Int32Array =>
  images.map((image, edge) => (images[image] === edge ? image : -1));

/** Returns the number of each edge's mirror image; -1 if it has none or several. */
export function mirrorEdges(garment: MeasuredGarment): Int32Array {
  const images = new Int32Array(garment.edges.length).fill(-1);
  for (const a of garment.pieces) {
    const own = a.words.side === 0 ? foldingOf(garment, a, a) : undefined;
    const others = garment.pieces
      .filter((b) => b !== a && mayMirror(a, b))
      .map((b) => foldingOf(garment, a, b))
      .filter((one) => one !== undefined);
    const [only] = others;
    const chosen = own
      ? others.length < 2
        ? own
        : undefined
      : others.length === 1
        ? only
        : undefined;
    chosen?.images.forEach((image, k) => (images[a.first + k] = image));
  }
  return mutual(images);
}

/**
 * Adds the images of partly mirrored pieces. Their names decide which piece they mirror: themselves
 * or their other side.
 */
export function withPartImages(garment: MeasuredGarment, images: Int32Array): Int32Array {
  const {edges, pieces} = garment;
  const isImage = (one: number, other: number): boolean => {
    const [a, b] = [edges[one], edges[other]];
    return a !== undefined && b !== undefined && unlikeness(garment, a, b) <= most;
  };
  const all = images.slice();
  for (const a of pieces) {
    if (images.subarray(a.first, a.first + a.count).some((image) => image >= 0)) continue;
    const [meant, ...more] =
      a.words.side === 0 ? [a] : pieces.filter((b) => b !== a && mayMirror(a, b));
    if (!meant || more.length > 0) continue;
    const found = partlyFolded(garment, a, meant, isImage);
    found?.forEach((image, k) => (all[a.first + k] = image));
  }
  return mutual(all);
}
