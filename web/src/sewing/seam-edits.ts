/** Applies edits of the sewing tool to a garment and to mirror images of its edges. */
import type {Run} from '../clicks/run.js';
import type {SeamEdit, Suggestion} from '../clicks/seam-tool.js';
import type {EdgeOfPiece, GarmentDocument} from '../model/garment/garment-document.js';
import {
  after,
  sameEdge,
  seamAt,
  setOpen,
  sew,
  sideLength,
  splitEdge,
  turnSeam,
  twinOf,
  unchanged,
  unsew,
  unsewAll,
  type Edited,
  type Sewn,
} from '../model/garment/edits.js';
import {mirrorImage} from '../pairing/image.js';

/** Returns the mirror image of a run; it is sewn in the opposite direction around its outline. */
function imageOf(document: GarmentDocument, run: Run): Run | undefined {
  const images = run.flatMap((edge) => mirrorImage(document, edge) ?? []);
  return images.length === run.length ? images.reverse() : undefined;
}

const overlap = (one: Run, other: Run): boolean =>
  one.some((edge) => other.some((each) => sameEdge(edge, each)));

const isFree = (document: GarmentDocument, run: Run): boolean =>
  run.every((edge) => seamAt(document, edge) === undefined);

/** Sews two sides, and their mirror images if neither is sewn. */
function sewn(document: GarmentDocument, {a, b, sameDirection}: Sewn): Edited {
  const first = sew(document, {a, b, sameDirection});
  const [imageA, imageB] = [imageOf(document, a), imageOf(document, b)];
  if (!imageA || !imageB || overlap([...imageA, ...imageB], [...a, ...b])) return first;
  if (overlap(imageA, imageB) || !isFree(document, [...imageA, ...imageB])) return first;
  const [otherA, otherB] = [imageA, imageB].map((run) => run.flatMap(first.edgesOf));
  if (!otherA || !otherB) return first;
  return after(first, (next) => sew(next, {a: otherA, b: otherB, sameDirection}));
}

/** @param isExact omits the mirror images */
function sewnAll(
  document: GarmentDocument,
  seams: readonly Suggestion[],
  isExact: boolean,
): Edited {
  return seams.reduce((done, {a, b, sameDirection}) => {
    const [one, other] = [a.flatMap(done.edgesOf), b.flatMap(done.edgesOf)];
    return isFree(done.document, [...one, ...other])
      ? after(done, (next) => (isExact ? sew : sewn)(next, {a: one, b: other, sameDirection}))
      : done;
  }, unchanged(document));
}

/** Replaces seams that were sewn too short. */
function joined(
  document: GarmentDocument,
  {seams, a, b, sameDirection}: Extract<SeamEdit, {readonly kind: 'join'}>,
): Edited {
  return after(unsewAll(document, seams), (next) => sewn(next, {a, b, sameDirection}));
}

function split(document: GarmentDocument, edge: EdgeOfPiece, share: number): Edited {
  const first = splitEdge(document, edge, share);
  const image = mirrorImage(document, edge);
  const parts = image && !sameEdge(image, edge) ? first.edgesOf(image) : [];
  const [only] = parts;
  // an edge sewn to its own mirror image was split together with it
  return only && parts.length === 1
    ? after(first, (next) => splitEdge(next, only, 1 - share))
    : first;
}

/** Returns the seam between the mirror images of the two sides of a seam. */
function imageSeam(document: GarmentDocument, number: number): number | undefined {
  const seam = document.seams[number];
  const [a, b] = seam ? [seam.a, seam.b].map((edge) => mirrorImage(document, edge)) : [];
  const image = a && seamAt(document, a);
  const found = image === undefined ? undefined : document.seams[image];
  const isImage = a && b && found && image !== number && sameEdge(twinOf(found, a), b);
  return isImage ? image : undefined;
}

/** Changes a seam and its mirror image, the later first, so that the other index stays valid. */
function inBoth(
  document: GarmentDocument,
  number: number,
  change: (document: GarmentDocument, seam: number) => Edited,
): Edited {
  const image = imageSeam(document, number);
  const both = [number, ...(image === undefined ? [] : [image])].sort((one, other) => other - one);
  return both.reduce(
    (done, seam) => after(done, (next) => change(next, seam)),
    unchanged(document),
  );
}

function opened(document: GarmentDocument, run: Run, open: boolean): Edited {
  const all = [...run, ...(imageOf(document, run) ?? [])].filter((edge) =>
    isFree(document, [edge]),
  );
  return all.reduce(
    (done, edge) => after(done, (next) => setOpen(next, edge, open)),
    unchanged(document),
  );
}

export function editedBy(
  document: GarmentDocument,
  edit: Exclude<SeamEdit, {readonly kind: 'match'}>,
): Edited {
  switch (edit.kind) {
    case 'sew':
      return sewn(document, edit);
    case 'sewAll':
      return sewnAll(document, edit.seams, edit.exactly === true);
    case 'join':
      return joined(document, edit);
    case 'split':
      return split(document, edit.edge, edit.share);
    case 'unsew':
      return inBoth(document, edit.seam, unsew);
    case 'turn':
      return inBoth(document, edit.seam, turnSeam);
    case 'open':
      return opened(document, edit.run, edit.open);
  }
}

/** A side that is longer by more than this share is gathered. */
const gathers = 0.1;

/** Returns the difference in length of two sides, in cm and as a share of the shorter side. */
export function easeOf(
  document: GarmentDocument,
  a: Run,
  b: Run,
): {readonly cm: number; readonly share: number} {
  const [one, other] = [sideLength(document, a), sideLength(document, b)];
  return {cm: Math.abs(one - other), share: Math.max(one, other) / Math.min(one, other) - 1};
}

/** Returns whether the sides of a seam differ too much in length for a continuous print. */
function isGathered(document: GarmentDocument, number: number): boolean {
  const seam = document.seams[number];
  return seam !== undefined && easeOf(document, [seam.a], [seam.b]).share > gathers;
}

/** Returns the new seams that are gathered. */
export const newGathers = (before: GarmentDocument, after: GarmentDocument): readonly number[] =>
  after.seams.flatMap((_, number) =>
    number >= before.seams.length && isGathered(after, number) ? [number] : [],
  );

/** Returns the seams that an edit has made gathered, by their numbers afterwards. */
export const grownGathers = (
  before: GarmentDocument,
  {document, seamsOf}: Edited,
): readonly number[] =>
  before.seams.flatMap((_, number) =>
    isGathered(before, number) ? [] : seamsOf(number).filter((one) => isGathered(document, one)),
  );
