/** Which edge is the mirror image of which, on the same piece or on its twin. */
import type {MeasuredEdge, MeasuredGarment, MeasuredPiece} from './edges.js';

/** Images that differ by more are none: shares of a length, and angles. [rad] */
const most = 0.06;

/** How far one edge is from the mirror image of another; corners apart, since they swap ends. */
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
  /** The images, in the order of the first piece's edges. */
  readonly images: readonly number[];
  readonly unlikeness: number;
  /** How far the image is from one about the grain, where the outline alone leaves several. */
  readonly tilt: number;
}

/** How far two middles of edges are from being mirrored about the grain. */
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

/** The best way to mirror one piece onto another; undefined where it does not fit. */
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

/** As much of an outline has an image at least, where the rest differs: as darts of a back that closes on one side. */
const leastPart = 0.5;

/** Where outlines are no mirror images as a whole: the longest part that is one. Images are -1 beyond it. */
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

/** Whether names allow two pieces, or one with itself, to be mirror images. */
function mayMirror(a: MeasuredPiece, b: MeasuredPiece): boolean {
  const [one, other] = [a.words, b.words];
  return (
    one.side === (-other.side as typeof one.side) &&
    one.face === other.face &&
    one.isSleeve === other.isSleeve
  );
}

/** An image is one only where it is mutual. */
const mutual = (images: Int32Array): Int32Array =>
  images.map((image, edge) => (images[image] === edge ? image : -1));

/** For every edge the number of its mirror image; -1 where it has none, or more than one. */
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

/** With the images of pieces that mirror themselves or their other side, as names have it, in part only. */
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
