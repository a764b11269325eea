/** Checks a drape by its file and by its result, independently of the file's own figures. */
import type {SolveResult} from '@/model/result/result.js';
import type {DrapeFile, DrapeFilePiece, Place} from '@/model/documents/drape-file.js';
import {distance, type Point} from '@/model/geometry/vectors.js';
import {ClosedSurface, openEdges} from './closed-surface.js';
import {cutArea, energiesOf, forcesOf, imageOf, type Energies, type RatedDrape} from './energy.js';
import {alongLine, at, greatest, sum} from '../plane.js';
import {SewnCloth, type ClothTriangle} from './sewn-cloth.js';
import {distance3, dot3, middle3, norm3, plus3} from './space.js';

export interface Spread {
  readonly median: number;
  readonly p99: number;
  readonly max: number;
}

/** Measurements of a drape, from its positions. Lengths in cm. */
export interface DrapeVerdict {
  /** Violations of the format, or differences from the result, a message each. */
  readonly faults: readonly string[];
  /** Distance between vertices that are sewn together. */
  readonly gap: number;
  /**
   * For vertices and middles of triangles: depth in the form, and share with at least 0.5 mm of
   * distance.
   */
  readonly depth: number;
  readonly clear: number;
  /**
   * Largest principal stretch less 1; 1 less the smallest, and the same more than 4 cm from
   * gathers.
   */
  readonly tension: Spread;
  readonly compression: Spread;
  readonly flatCompression: Spread;
  /**
   * Relative excess of edges along seams over the longer side as cut, or deficit to the shorter
   * one.
   */
  readonly sewnLength: Spread;
  /** Distance between the mirror image of a vertex and the vertex it maps to. */
  readonly asymmetry: number;
  readonly energies: Energies;
  /** The file's last energy over that of its positions, less 1. */
  readonly energyOff: number;
  /**
   * Stages that end with more energy than they begin with, or than the one before on the same mesh.
   */
  readonly rises: readonly string[];
  readonly crossings: number;
  /** Height above the floor. */
  readonly lowest: number;
  /** Height of the top edge over the waist, if the garment hangs from the waist. */
  readonly waist?: number;
}

/** Precision of lengths in a file, in two dimensions. [cm] */
const precision = 1.5e-4;
/** Beyond the contact offset by more than this, nothing touches the form. [cm] */
const touching = 0.4;
/** A side that is longer than the other by more than this share of its length is gathered. */
const gathered = 0.05;
const besideGathers = 4;
/** A garment hangs from the waist if none of its vertices is higher above it. */
const aboveWaist = 8;

export function judgeDrape(file: DrapeFile, result: SolveResult): DrapeVerdict {
  const cloth = new SewnCloth(file);
  const surface = new ClosedSurface(file.form);
  const samples = [...cloth.places, ...cloth.triangles.map(({worn}) => middle3(...worn))];
  const distances = samples.map((place) => surface.distance(place));
  const stretches = cloth.triangles.map(principalStretches);
  const energies = energiesOf(ratedBy(result, file), cloth);
  const stated = file.stages.at(-1)?.energy.at(-1) ?? NaN;
  const isFlat = awayFromGathers(file, result);
  const lowest = Math.min(...cloth.places.map((place) => place[1]));
  const waist = waistOf(file, cloth);
  return {
    faults: [...faultsIn(file, result), ...faultsOfForm(file)],
    gap: greatest(file.seams.flatMap((seam) => gapsOf(seam, file.pieces))),
    depth: greatest(distances.map((distance) => -distance)),
    clear: distances.filter((distance) => distance >= 0.05).length / distances.length,
    tension: spreadOf(stretches.map(([, most]) => most - 1)),
    compression: spreadOf(stretches.map(([least]) => 1 - least)),
    flatCompression: spreadOf(
      stretches.flatMap(([least], k) => (isFlat(at(cloth.triangles, k)) ? [1 - least] : [])),
    ),
    sewnLength: spreadOf(file.seams.flatMap((seam) => sewnLengths(seam, file.pieces))),
    asymmetry: greatest(file.mirrors.flatMap((mirror) => asymmetries(mirror, file.pieces))),
    energies,
    energyOff: stated / (energies.membrane + energies.bending + energies.weight) - 1,
    rises: risesIn(file),
    crossings: cloth.crossings(),
    lowest,
    ...(waist !== undefined && {waist}),
  };
}

/** Distances between two drapes of one result. [cm] */
export function apart(
  one: DrapeFile,
  other: DrapeFile,
): {readonly rms: number; readonly max: number} {
  const distances = one.pieces.flatMap(({positions}, piece) =>
    positions.map((place, vertex) =>
      distance3(place, at(at(other.pieces, piece).positions, vertex)),
    ),
  );
  const squares = sum(distances.map((distance) => distance ** 2));
  return {rms: Math.sqrt(squares / distances.length), max: greatest(distances)};
}

function spreadOf(values: readonly number[]): Spread {
  const sorted = values.toSorted((a, b) => a - b);
  const quantile = (share: number) =>
    sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))] ?? 0;
  return {median: quantile(0.5), p99: quantile(0.99), max: quantile(1)};
}

/** Principal stretches of the map from a triangle as cut to space, the smaller first. */
function principalStretches(triangle: ClothTriangle): readonly [number, number] {
  const [x, y] = [imageOf(triangle, [1, 0]), imageOf(triangle, [0, 1])];
  const [a, b, c] = [dot3(x, x), dot3(x, y), dot3(y, y)];
  const [mean, half] = [(a + c) / 2, Math.hypot((a - c) / 2, b)];
  return [Math.sqrt(Math.max(0, mean - half)), Math.sqrt(mean + half)];
}

type Seam = DrapeFile['seams'][number];

const placesOf = (pieces: readonly DrapeFilePiece[], {piece, vertices}: Seam['a']): Place[] =>
  vertices.map((vertex) => at(at(pieces, piece).positions, vertex));

function gapsOf({a, b}: Seam, pieces: readonly DrapeFilePiece[]): number[] {
  const other = placesOf(pieces, b);
  return placesOf(pieces, a).map((place, k) => distance3(place, at(other, k)));
}

/** Eased and gathered sides may have any length between their two lengths as cut. */
function sewnLengths({a, b}: Seam, pieces: readonly DrapeFilePiece[]): number[] {
  const [one, other] = [a, b].map(({piece, vertices}) =>
    alongLine(vertices).map(([u, v]) => {
      const {shape} = at(pieces, piece);
      return distance(at(shape, u), at(shape, v));
    }),
  );
  return alongLine(placesOf(pieces, a)).map(([p, q], k) => {
    const cut = [at(one ?? [], k), at(other ?? [], k)];
    const worn = distance3(p, q);
    return Math.max(0, worn / Math.max(...cut) - 1, 1 - worn / Math.min(...cut));
  });
}

function asymmetries(
  {pieces: [from, to], image}: DrapeFile['mirrors'][number],
  pieces: readonly DrapeFilePiece[],
): number[] {
  return image.map((vertex, k) => {
    const [x, y, z] = at(at(pieces, from).positions, k);
    return distance3([-x, y, z], at(at(pieces, to).positions, vertex));
  });
}

function awayFromGathers(
  file: DrapeFile,
  result: SolveResult,
): (triangle: ClothTriangle) => boolean {
  const lines = file.seams
    .filter(({stitch}) => Math.abs(at(result.seams, stitch).lengthRatio - 1) > gathered)
    .flatMap(({a, b}) => [a, b]);
  return ({piece, cut}) => {
    const near = lines.filter((side) => side.piece === piece);
    return near.every(({vertices}) =>
      vertices.every((vertex) => {
        const point = at(at(file.pieces, piece).shape, vertex);
        return cut.every((corner) => distance(corner, point) > besideGathers);
      }),
    );
  };
}

function risesIn({stages}: DrapeFile): string[] {
  const rises = stages
    .filter(({energy}) => !((energy.at(-1) ?? NaN) <= (energy[0] ?? NaN)))
    .map(({name}) => `the stage '${name}' ends with more energy than it begins with`);
  for (const [before, after] of alongLine(stages)) {
    if (before.vertices !== after.vertices) continue;
    if ((after.energy.at(-1) ?? NaN) <= (before.energy.at(-1) ?? NaN)) continue;
    rises.push(`the stage '${after.name}' ends with more energy than '${before.name}'`);
  }
  return rises;
}

/**
 * The force on all vertices that the form does not touch, over the weight of the fabric. It is 0 at
 * rest, where the form bears the whole weight by pressure and friction. Fabric on fabric away from
 * the form counts as not touching. Requires exact positions: fabric is stiff, and the 1e-4 cm
 * precision of a file makes some percent.
 */
export function unborne(file: DrapeFile, result: SolveResult): number {
  const cloth = new SewnCloth(file);
  const surface = new ClosedSurface(file.form);
  const reach = file.contactOffset + touching;
  let left: Place = [0, 0, 0];
  let whole = 0;
  for (const [vertex, {pull, weight}] of forcesOf(ratedBy(result, file), cloth)) {
    whole += weight;
    if (surface.distance(at(cloth.places, vertex)) <= reach) continue;
    left = plus3(plus3(left, pull), [0, -weight, 0]);
  }
  return norm3(left) / whole;
}

/** The energy of the fabric at the positions of the file. [J] */
export function restingEnergy(file: DrapeFile, result: SolveResult): number {
  const {membrane, bending, weight} = energiesOf(ratedBy(result, file), new SewnCloth(file));
  return membrane + bending + weight;
}

const ratedBy = ({seams}: SolveResult, file: DrapeFile): RatedDrape => ({
  file,
  ratios: seams.map(({lengthRatio}) => lengthRatio),
});

function waistOf({pieces, form}: DrapeFile, cloth: SewnCloth): number | undefined {
  const {waistHeight} = form.body;
  const highest = Math.max(...cloth.places.map((place) => place[1]));
  const hangs = pieces.every(({part}) => part === 'torso' || part.endsWith('leg'));
  if (!hangs || highest > waistHeight + aboveWaist) return undefined;
  const heights = cloth
    .rims()
    .map((rim) => sum(rim.map((vertex) => at(cloth.places, vertex)[1])) / rim.length);
  return Math.max(...heights) - waistHeight;
}

/** Inconsistencies of a file with this result. */
function faultsIn(file: DrapeFile, result: SolveResult): string[] {
  const faults: string[] = [];
  const must = (holds: boolean, sentence: string) => {
    if (!holds) faults.push(sentence);
  };
  must(file.pieces.length === result.pieces.length, 'there are other pieces in the result');
  must(file.seams.length === result.seams.length, 'there are other seams in the result');
  if (faults.length > 0) return faults;
  file.pieces.forEach((piece, k) => {
    const {name, outline, resultVertices, positions, shape} = piece;
    const known = at(result.pieces, k);
    must(name === known.name, `the result calls '${name}' '${known.name}'`);
    must(positions.flat().every(Number.isFinite), `a place of '${name}' is none`);
    must(positions.length === shape.length, `'${name}' has other vertices in space`);
    for (const state of ['rest', 'shape'] as const) {
      const off = greatest(
        outline.map((vertex, n) => {
          const asked: Point = at(known[state], at(resultVertices, n));
          return distance(at(piece[state], vertex), asked);
        }),
      );
      must(off <= precision, `the outline of '${name}' is ${off} cm from that of the result`);
    }
  });
  const cut = new SewnCloth(file).triangles;
  must(
    cut.every((triangle) => cutArea(triangle) > 0),
    'a triangle is turned over as cut',
  );
  file.seams.forEach((seam, k) => {
    const known = at(result.seams, seam.stitch);
    must(seam.stitch === k, `seam ${k} is called ${seam.stitch}`);
    must(seam.a.vertices.length === seam.b.vertices.length, `the sides of seam ${k} differ`);
    for (const side of ['a', 'b'] as const) {
      const {piece, vertices} = seam[side];
      must(piece === known[side].piece, `seam ${k} joins another piece`);
      const {outline, resultVertices} = at(file.pieces, piece);
      const named = vertices.map((vertex) => resultVertices[outline.indexOf(vertex)] ?? -1);
      const isSame = runsAlong(named, known[side].vertices);
      must(isSame, `side ${side} of seam ${k} is another line in the result`);
    }
  });
  return faults;
}

/** Returns whether a line contains another one in its order, from its first to its last vertex. */
function runsAlong(part: readonly number[], whole: readonly number[]): boolean {
  let from = 0;
  for (const vertex of part) {
    const found = whole.indexOf(vertex, from);
    if (found < 0) return false;
    from = found + 1;
  }
  return part[0] === whole[0] && part.at(-1) === whole.at(-1);
}

function faultsOfForm({form}: DrapeFile): string[] {
  const open = openEdges(form.triangles);
  return open > 0 ? [`the form's surface has ${open} edges that are open`] : [];
}
