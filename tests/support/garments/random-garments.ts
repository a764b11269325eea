/** Random small garments: valid in every respect, but mostly unusual. */
import * as fc from 'fast-check';
import type {
  Curvature,
  GarmentCodeSpecification,
  Panel,
  PanelEdge,
  Point,
  Stitch,
  StitchEnd,
  Symmetries,
} from 'seamwise/node';

import {distance, minus, plus} from '@/model/geometry/vectors.js';
import {at, scale} from '../plane.js';

/** Bend of an edge, in edge lengths: along the edge, and to its left. */
type Bend =
  | {readonly kind: 'straight' | 'null'}
  | {readonly kind: 'point' | 'quadratic'; readonly by: Point}
  | {readonly kind: 'cubic'; readonly by: readonly [Point, Point]}
  | {readonly kind: 'circle'; readonly radius: number; readonly right: boolean};

/**
 * A counter-clockwise panel in cm. Edge k runs from vertex k to the next; `image` is its mirror
 * image.
 */
interface Draft {
  readonly vertices: readonly Point[];
  readonly bends: readonly Bend[];
  readonly twin: 'none' | 'itself' | 'before';
}

export interface DraftedGarment {
  readonly garment: GarmentCodeSpecification;
  readonly names: readonly string[];
  /** True mirror symmetries of the pieces; the stitches agree with them. */
  readonly symmetries: Symmetries;
}

/** Evenly distributed, unlike fc.double, which prefers tiny numbers. */
export const between = (min: number, max: number): fc.Arbitrary<number> =>
  fc.nat(10_000).map((k) => min + ((max - min) * k) / 10_000);

const sideways = between(-0.22, 0.22);

const bend: fc.Arbitrary<Bend> = fc.oneof(
  {weight: 4, arbitrary: fc.constant<Bend>({kind: 'straight'})},
  fc.constant<Bend>({kind: 'null'}),
  fc.record({
    kind: fc.constantFrom('point', 'quadratic'),
    by: fc.tuple(between(0.3, 0.7), sideways),
  }),
  fc.record({
    kind: fc.constant('cubic'),
    by: fc.tuple(fc.tuple(between(0.1, 0.5), sideways), fc.tuple(between(0.5, 0.9), sideways)),
  }),
  fc.record({kind: fc.constant('circle'), radius: between(0.8, 4), right: fc.boolean()}),
);

/** A panel with corners around a centre, so that straight outlines never cross themselves. */
const freePanel: fc.Arbitrary<Draft> = fc.integer({min: 3, max: 7}).chain((n) =>
  fc
    .record({
      radii: fc.array(between(1.2, 3.5), {minLength: n, maxLength: n}),
      jitter: fc.array(between(0.1, 0.9), {minLength: n, maxLength: n}),
      bends: fc.array(bend, {minLength: n, maxLength: n}),
      centre: fc.tuple(between(-20, 20), between(-20, 20)),
    })
    .map(({radii, jitter, bends, centre}) => ({
      vertices: radii.map((radius, k) => {
        const angle = (2 * Math.PI * (k + at(jitter, k))) / n;
        return plus(centre, scale([Math.cos(angle), Math.sin(angle)], radius));
      }),
      bends,
      twin: 'none',
    })),
);

const reversed = (b: Bend): Bend => {
  const back = ([x, y]: Point): Point => [1 - x, y];
  if (b.kind === 'point' || b.kind === 'quadratic') return {...b, by: back(b.by)};
  if (b.kind === 'cubic') return {...b, by: [back(b.by[1]), back(b.by[0])]};
  return b;
};

const mirroredPoint = ([x, y]: Point): Point => [-x, y];

/** The mirror image, counter-clockwise again: edge k becomes edge n - 2 - k. */
function mirrorImage({vertices, bends}: Draft): Draft {
  const n = vertices.length;
  return {
    vertices: vertices.map((_, k) => mirroredPoint(at(vertices, n - 1 - k))),
    bends: bends.map((_, k) => reversed(at(bends, (2 * n - 2 - k) % n))),
    twin: 'before',
  };
}

const imageEdge = (n: number, k: number): number => (2 * n - 2 - k) % n;

/** A panel that mirrors onto itself at x = 0: a line from the bottom to the top, and its image. */
const symmetricPanel: fc.Arbitrary<Draft> = fc.integer({min: 2, max: 3}).chain((half) =>
  fc
    .record({
      widths: fc.array(between(0.8, 3), {minLength: half, maxLength: half}),
      steps: fc.array(between(0.8, 3), {minLength: half, maxLength: half}),
      bends: fc.array(bend, {minLength: half - 1, maxLength: half - 1}),
    })
    .map(({widths, steps, bends}) => {
      let y = 0;
      const right = widths.map((x, k): Point => {
        y += at(steps, k);
        return [x, y];
      });
      const left = right.toReversed().map(mirroredPoint);
      const across: Bend = {kind: 'straight'};
      const all = [...bends, across, ...bends.toReversed().map(reversed), across];
      return {vertices: [...right, ...left], bends: all, twin: 'itself'};
    }),
);

interface EdgeRef {
  readonly piece: number;
  readonly edge: number;
}

/** Random matches of all edges; mirror images are matched together. */
function stitchesOf(
  drafts: readonly Draft[],
  order: readonly number[],
  share: number,
): (readonly [EdgeRef, EdgeRef])[] {
  const image = ({piece, edge}: EdgeRef): EdgeRef | null => {
    const {twin, vertices} = at(drafts, piece);
    if (twin === 'itself') return {piece, edge: imageEdge(vertices.length, edge)};
    const hasTwin = drafts[piece + 1]?.twin === 'before';
    if (hasTwin) return {piece: piece + 1, edge: imageEdge(vertices.length, edge)};
    return null;
  };
  const isSame = (a: EdgeRef, b: EdgeRef) => a.piece === b.piece && a.edge === b.edge;
  const orbits = drafts.flatMap(({vertices, twin}, piece) =>
    vertices.flatMap((_, edge): [EdgeRef, EdgeRef][] => {
      if (twin === 'before') return [];
      const own = {piece, edge};
      const other = image(own) ?? own;
      return twin === 'itself' && other.edge < edge ? [] : [[own, other]];
    }),
  );
  const ranked = orbits
    .map((orbit, k) => ({orbit, rank: order[k] ?? 0}))
    .sort((a, b) => a.rank - b.rank)
    .map(({orbit}) => orbit)
    .slice(0, Math.ceil(share * orbits.length));
  const isSelf = ([a, b]: [EdgeRef, EdgeRef]) => isSame(a, b);
  const singles = ranked.filter(isSelf);
  const doubles = ranked.filter((orbit) => !isSelf(orbit));
  const matched = (list: [EdgeRef, EdgeRef][]) =>
    list.flatMap(([a, imageA], k) => {
      const next = list[k + 1];
      if (k % 2 === 1) return [];
      if (!next) return isSame(a, imageA) ? [] : [[a, imageA] as const];
      const [b, imageB] = next;
      return isSame(a, imageA) ? [[a, b] as const] : [[a, b] as const, [imageA, imageB] as const];
    });
  return [...matched(singles), ...matched(doubles)];
}

interface Spelling {
  readonly unitsInMeter: number | undefined;
  readonly absolute: boolean;
  /** Per panel: the file shows its back. */
  readonly backs: readonly boolean[];
}

function panelText(draft: Draft, {unitsInMeter = 100, absolute}: Spelling, back: boolean): Panel {
  const unit = unitsInMeter / 100;
  const flip = (p: Point): Point => (back ? mirroredPoint(p) : p);
  const vertices = draft.vertices.map((p) => scale(flip(p), unit));
  const n = vertices.length;
  const edges = draft.bends.map((b, k): PanelEdge => {
    const endpoints = [k, (k + 1) % n] as const;
    const [from, to] = [at(vertices, k), at(vertices, (k + 1) % n)];
    const control = ([x, y]: Point): Point => {
      const left = back ? -y : y;
      if (!absolute) return [x, left];
      const along = minus(to, from);
      return plus(plus(from, scale(along, x)), scale([-along[1], along[0]], left));
    };
    const curvature = curvatureText(b, control, distance(from, to), back);
    return curvature === undefined ? {endpoints} : {endpoints, curvature};
  });
  return {vertices, edges};
}

function curvatureText(
  b: Bend,
  control: (p: Point) => Point,
  chord: number,
  back: boolean,
): Curvature | undefined {
  switch (b.kind) {
    case 'straight':
      return undefined;
    case 'null':
      return null as unknown as Curvature; // occurs in real files
    case 'point':
      return control(b.by);
    case 'quadratic':
      return {type: 'quadratic', params: [control(b.by)]};
    case 'cubic':
      return {type: 'cubic', params: [control(b.by[0]), control(b.by[1])]};
    case 'circle':
      return {type: 'circle', params: [b.radius * chord, 0, Number(b.right !== back)]};
  }
}

const group: fc.Arbitrary<readonly Draft[]> = fc.oneof(
  {weight: 2, arbitrary: freePanel.map((panel) => [panel])},
  symmetricPanel.map((panel) => [panel]),
  freePanel.map((panel) => [panel, mirrorImage(panel)]),
);

const freeDrafts = fc.array(freePanel, {minLength: 2, maxLength: 5});
const mirroredDrafts = fc
  .array(
    group.filter((drafts) => at(drafts, 0).twin === 'itself' || drafts.length === 2),
    {minLength: 1, maxLength: 3},
  )
  .map((drafts) => drafts.flat().slice(0, 6));

/** Moves the corners of mirror images a little, as careless drafting does. */
function roughened(drafts: readonly Draft[], by: number, noise: readonly Point[]): Draft[] {
  return drafts.map((draft) => {
    if (draft.twin === 'none') return draft;
    const moved = draft.vertices.map((p, k) => plus(p, scale(at(noise, k), by)));
    return {...draft, vertices: moved};
  });
}

/** Names found in files, and very unsuitable ones. */
const naming = fc.constantFrom(
  'panel',
  'panel',
  'Ärmel 袖',
  'two\nlines',
  '\u0000\u2028"\\',
  'x'.repeat(300),
);

/**
 * Two to six panels of three to seven edges, some seen from the back, some mirrored, sewn at
 * random.
 */
export const draftedGarment: fc.Arbitrary<DraftedGarment> = fc
  .oneof(freeDrafts, mirroredDrafts)
  .chain((drafts) =>
    fc.record({
      drafts: fc.constant(drafts),
      order: fc.array(fc.nat(), {minLength: 42, maxLength: 42}),
      share: between(0, 1),
      roughness: fc.oneof(fc.constant(0), between(0, 0.1)),
      noise: fc.array(fc.tuple(between(-1, 1), between(-1, 1)), {minLength: 7, maxLength: 7}),
      naming,
      wrong: fc.array(fc.constantFrom('absent', 'absent', 'absent', null, 'right_wrong'), {
        minLength: 21,
        maxLength: 21,
      }),
      spelling: fc.record({
        unitsInMeter: fc.constantFrom(undefined, 100, 300, 1000, 39.37),
        absolute: fc.boolean(),
        backs: fc.array(fc.boolean(), {minLength: 6, maxLength: 6}),
      }),
    }),
  )
  .map(({drafts: exact, order, share, roughness, noise, naming, wrong, spelling}) => {
    const drafts = roughened(exact, roughness, noise);
    const names = drafts.map((_, k) => `${naming} ${k}`);
    const end = ({piece, edge}: EdgeRef): StitchEnd => ({panel: at(names, piece), edge});
    const isFree = drafts.every(({twin}) => twin === 'none');
    const stitches = stitchesOf(drafts, order, share).map(([a, b], k): Stitch => {
      const word = isFree ? wrong[k] : 'absent'; // otherwise images would have to agree
      if (word === 'absent' || word === undefined) return [end(a), end(b)];
      return [end(a), end(b), word];
    });
    const panels = Object.fromEntries(
      drafts.map((draft, k) => [at(names, k), panelText(draft, spelling, at(spelling.backs, k))]),
    );
    const properties = {
      curvature_coords: spelling.absolute ? ('absolute' as const) : ('relative' as const),
      ...(spelling.unitsInMeter === undefined ? {} : {units_in_meter: spelling.unitsInMeter}),
    };
    return {
      garment: {pattern: {panels, stitches}, properties},
      names,
      symmetries: {
        symmetries: drafts.flatMap(({twin}, k): Symmetries['symmetries'] => {
          if (twin === 'itself') return [{kind: 'piece', piece: at(names, k)}];
          if (twin !== 'before') return [];
          return [{kind: 'pair', pieces: [at(names, k - 1), at(names, k)]}];
        }),
      },
    };
  });
