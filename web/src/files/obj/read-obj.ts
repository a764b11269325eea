/**
 * Reads OBJ with texture coordinates as a drawing: garments of simulators, with their pieces flat
 * in the texture.
 */
import type {Drawing, DrawnPiece, DrawnSeam, Run} from '../../model/garment/imported-drawing.js';
import type {FileUnit} from '../../model/garment/garment-document.js';
import type {Point} from '../../model/geometry/vectors.js';
import {boxOf, signedArea} from '../../model/geometry/polyline.js';
import {FileError} from '../../model/base/versioned-file.js';
import {pathThrough} from '../base/curve-fit.js';
import {guessedUnit} from '../base/units.js';
import {welded} from './arrays.js';
import {panelsOf, rimsOf, type Panels} from './panels.js';
import {readMesh, type ObjMesh} from './parse.js';
import {runsOfRims, type Rim, type RimRuns} from './seams.js';
import {flatScale, type FlatScale} from './flat-scale.js';

/**
 * Greatest deviation of curves from a boundary, as a share of the largest piece: 0.1 mm per metre.
 */
const fitting = 1e-4;

/** Greatest number of panels, above that of any garment. */
const mostPanels = 1000;

/**
 * Reads an OBJ file.
 * @param file file name for messages
 * @param units unit of the vertices, if known
 * @throws {FileError} without flat pieces
 */
export function readObj(bytes: Uint8Array, file: string, units?: FileUnit): Drawing {
  const mesh = flatPart(readMesh(bytes, file), file);
  const sides = {
    vertices: weldedCorners(mesh.corners, mesh.vertices, 3),
    flat: weldedCorners(mesh.flatCorners, mesh.flat, 2),
  };
  const panels = panelsOf(sides);
  const count = panels.panelOf.filter((root, triangle) => root === triangle).length;
  if (count > mostPanels) {
    throw new FileError(
      file,
      `falls into ${count} pieces in its texture, as no garment does; export it with the UVs of its pattern.`,
      {reason: 'model'},
    );
  }
  if (panels.broken > 0) {
    throw new FileError(
      file,
      `has ${panels.broken} edges within pieces at which more than two faces meet, or faces that are turned over; remove doubles, make the normals consistent, and export one layer.`,
    );
  }
  const scale = flatScale(mesh);
  const {rims, turned} = rimsInTrueSize(mesh, panels, scale);
  const found = runsOfRims(rims, panels.sewnTo, sides.vertices);
  const pieces = piecesOf(mesh, rims, found);
  const largest = Math.max(
    ...pieces.drawn.map(({sewn}) => longerSide(sewn.map(({start}) => start))),
  );
  return {
    kind: 'obj',
    sizes: [],
    unit: units
      ? {unit: units, because: 'stated', isSure: true, others: []}
      : guessedUnit({largest, because: 'size'}),
    pieces: pieces.drawn,
    seams: pieces.seams,
    notes: [
      ...scaleNotes(scale),
      ...(panels.crowded > 0
        ? [`At ${panels.crowded} edges more than two pieces meet; they are left unsewn.`]
        : []),
      ...(turned > 0
        ? [`${turned} pieces lie on their faces in the texture, and were turned over.`]
        : []),
    ],
  };
}

/** The note on a scale that was measured on the mesh. */
function scaleNotes({across, up, agreeing, isMeasured}: FlatScale): string[] {
  if (!isMeasured && agreeing > fewAgreeing) return [];
  const length = (factor: number): string => Number(factor.toPrecision(4)).toString();
  const size =
    across === up
      ? `${length(across)} times`
      : `${length(across)} times across and ${length(up)} times up`;
  return [
    `The pieces are taken ${size} as large as in the texture, as the mesh has them; ${(100 * agreeing).toFixed(0)} % of its edges agree within 1 %.`,
  ];
}

/** Share of edges below which the mesh is stretched, so that sizes are uncertain. */
const fewAgreeing = 0.5;

/** The triangles with texture coordinates. */
function flatPart(mesh: ObjMesh, file: string): ObjMesh {
  const {corners, flatCorners, groups, hasFlat} = mesh;
  const isFlat = (triangle: number): boolean =>
    [0, 1, 2].every((k) => (flatCorners[3 * triangle + k] ?? -1) >= 0);
  const all = groups.length;
  let count = 0;
  for (let triangle = 0; triangle < all; triangle++) if (isFlat(triangle)) count++;
  if (all === 0)
    throw new FileError(file, 'has no faces; export the mesh of the garment.', {reason: 'model'});
  if (count === 0) {
    throw new FileError(
      file,
      hasFlat
        ? 'has texture coordinates (vt) that no face names; export it with UVs on its faces (f v/vt).'
        : 'has no texture coordinates (vt), in which the flat pieces would lie; export it with UVs.',
      {reason: 'model'},
    );
  }
  if (count === all) return mesh;
  const kept = Int32Array.from({length: all}, (_, k) => k).filter(isFlat);
  const take = (from: Int32Array): Int32Array =>
    new Int32Array(3 * count).map(
      (_, k) => from[3 * (kept[Math.floor(k / 3)] ?? 0) + (k % 3)] ?? 0,
    );
  return {
    ...mesh,
    ...{corners: take(corners), flatCorners: take(flatCorners)},
    groups: kept.map((triangle) => groups[triangle] ?? 0),
  };
}

function weldedCorners(corners: Int32Array, coordinates: Float64Array, size: number): Int32Array {
  const first = welded(coordinates, size);
  return corners.map((corner) => first[corner] ?? corner);
}

const longerSide = (points: readonly Point[]): number => {
  const {low, high} = boxOf(points);
  return Math.max(high[0] - low[0], high[1] - low[1]);
};

interface TrueRims {
  /** Ordered by panel, with the outer boundary of each first. */
  readonly rims: readonly Rim[];
  /** Number of mirrored pieces. */
  readonly turned: number;
}

/**
 * Boundaries in true size, with all pieces face up: pieces with the opposite orientation of most
 * were mirrored to fit the texture.
 */
function rimsInTrueSize(mesh: ObjMesh, panels: Panels, {across, up}: FlatScale): TrueRims {
  const byPanel = new Map<
    number,
    {readonly sides: number[]; readonly points: Point[]; readonly area: number}[]
  >();
  for (const sides of rimsOf(panels)) {
    const points = sides.map((side): Point => {
      const corner = 2 * (mesh.flatCorners[side] ?? 0);
      return [across * (mesh.flat[corner] ?? 0), up * (mesh.flat[corner + 1] ?? 0)];
    });
    const panel = panels.panelOf[Math.floor((sides[0] ?? 0) / 3)] ?? 0;
    const own = byPanel.get(panel) ?? [];
    own.push({sides, points, area: signedArea(points)});
    byPanel.set(panel, own);
  }
  const outer = [...byPanel.values()].map((own) =>
    own.sort((a, b) => Math.abs(b.area) - Math.abs(a.area)),
  );
  const facing = outer.reduce((sum, [largest]) => sum + (largest?.area ?? 0), 0);
  const isTurned = (area: number): boolean => area * facing < 0;
  return {
    rims: outer.flatMap((own, panel) =>
      own.map(({sides, points}) => ({
        ...{panel, sides},
        points: isTurned(own[0]?.area ?? 0) ? points.map(([x, y]): Point => [0 - x, y]) : points,
      })),
    ),
    turned: outer.filter(([largest]) => isTurned(largest?.area ?? 0)).length,
  };
}

function piecesOf(
  mesh: ObjMesh,
  rims: readonly Rim[],
  {runs, seams}: RimRuns,
): {readonly drawn: readonly DrawnPiece[]; readonly seams: readonly DrawnSeam[]} {
  const tolerance = fitting * Math.max(...rims.map(({points}) => longerSide(points)));
  const places: {piece: number; run: number}[] = [];
  const lines = runs.map(({rim, from, count}): Run => {
    const points = rims[rim]?.points ?? [];
    const along = Array.from(
      {length: count + 1},
      (_, k): Point => points[(from + k) % points.length] ?? [0, 0],
    );
    return {start: along[0] ?? [0, 0], cubics: pathThrough(along, tolerance)};
  });
  const names = namesOf(mesh, rims);
  const drawn = names.map((name, panel): DrawnPiece => {
    const own = rims.flatMap((rim, number) => (rim.panel === panel ? [number] : []));
    const loops = own.map((number) =>
      runs.flatMap(({rim}, k) => (rim === number ? [{k, line: lines[k]}] : [])),
    );
    loops[0]?.forEach(({k}, run) => (places[k] = {piece: panel, run}));
    const [sewn = [], ...holes] = loops.map((loop) => loop.flatMap(({line}) => line ?? []));
    return {
      name,
      quantity: {asDrawn: 1, mirrored: 0},
      ...{sewn, holes, notches: [], internalLines: [], drillHoles: [], words: []},
    };
  });
  return {
    drawn,
    seams: seams.flatMap(({a, b, sameDirection}) => {
      const [from, to] = [places[a], places[b]];
      return from && to ? [{a: from, b: to, sameDirection}] : [];
    }),
  };
}

/** Piece names, from the group of their triangles if each piece has its own. */
function namesOf(mesh: ObjMesh, rims: readonly Rim[]): string[] {
  const outer = rims.filter(({panel}, k) => rims[k - 1]?.panel !== panel);
  const groups = outer.map(({sides}) => mesh.groups[Math.floor((sides[0] ?? 0) / 3)] ?? 0);
  return groups.map((group, panel) => {
    const name = mesh.groupNames[group] ?? '';
    const isOwn = name !== '' && groups.filter((other) => other === group).length === 1;
    return isOwn ? name : `piece ${panel + 1}`;
  });
}
