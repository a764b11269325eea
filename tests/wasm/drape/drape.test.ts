/** Drapes of samples, checked by the contents of their files. */
import {
  drape,
  drapeFile,
  drapeText,
  glb,
  solve,
  type Drape,
  type DrapeFile,
  type DrapeMesh,
  type SolveResult,
} from 'seamwise/node';
import {describe, expect, it} from 'vitest';

import {apart, judgeDrape, restingEnergy, unborne} from '../../support/drape/judge.js';
import {broken, type DrapeLimits} from '../../support/drape/limits.js';
import {isThorough, sampleOf} from '../../support/level.js';
import {at} from '../../support/plane.js';
import {readGlb} from '../../support/drape/read-glb.js';
import {checks, sample, shortSkirt} from '../../support/garments/samples.js';

/** The drapes below are measured on results with even weights. */
const even = {visibility: 'even'} as const;

type Sample = Parameters<typeof sample>[0] | 'short skirt';

const garmentOf = (name: Sample): string => (name === 'short skirt' ? shortSkirt() : sample(name));

/** A commit compares bytes of the garment that takes the least time to drape. */
const usual: Sample = isThorough ? 'tee' : 'short skirt';

const solved = new Map<Sample, Promise<SolveResult>>();

/** Result of a sample on the usual print, solved once. */
function resultOf(name: Sample): Promise<SolveResult> {
  const known = solved.get(name) ?? solve({garment: garmentOf(name), print: checks, options: even});
  solved.set(name, known);
  return known;
}

type Effort = 1 | 2 | 4;

const draped = new Map<string, Promise<Drape>>();

/** Drape of that result, computed once for each effort. */
function drapeOf(name: Sample, effort: Effort = 1): Promise<Drape> {
  const key = `${name} ${effort}`;
  const known = draped.get(key) ?? resultOf(name).then((result) => drape(result, {effort}));
  draped.set(key, known);
  return known;
}

const bytesOf = ({buffer, byteOffset, byteLength}: ArrayBufferView) =>
  Buffer.from(buffer, byteOffset, byteLength);

/** Compares at once; `toEqual` takes seconds. */
const bytesAlike = (one: ArrayBufferView, other: ArrayBufferView): boolean =>
  bytesOf(one).equals(bytesOf(other));

/** Weaker limits of some samples: measured, and rounded up. */
const kept: Readonly<Partial<Record<Sample, Partial<DrapeLimits>>>> = {
  tee: {tension: {median: 0.005, p99: 0.035, max: 0.1}},
  'shift-dress': {sewnLength: 0.03},
  raglan: {crossings: 4},
  trousers: {sewnLength: 0.05, tension: {median: 0.005, p99: 0.045, max: 0.1}},
  'gathered-skirt': {sewnLength: 0.04, tension: {median: 0.005, p99: 0.04, max: 0.1}},
  'princess-dress': {sewnLength: 0.035, tension: {median: 0.005, p99: 0.035, max: 0.1}},
};

const judged: readonly Sample[] = [
  ...(['tee', 'gathered-skirt', 'shift-dress', 'raglan', 'princess-dress'] as const),
  ...(['asymmetric-dress', 'trousers', 'apron'] as const),
];

describe.each(sampleOf(1, judged))('%s', (name) => {
  it('hangs on its form as cloth does', async () => {
    const result = await resultOf(name);
    const file = drapeFile(result, await drapeOf(name));
    const verdict = judgeDrape(file, result);
    expect(broken(verdict, kept[name])).toEqual([]);
    const {gap, crossings, tension} = file.check;
    expect({gap, crossings}).toEqual({gap: verdict.gap, crossings: verdict.crossings});
    expect(tension.max).toBeCloseTo(verdict.tension.max, 3);
  });
});

const withoutPlaces: readonly Sample[] = ['apron', 'tee', 'trousers', 'hoodie'];

it.each(sampleOf(1, withoutPlaces))(
  'hangs %s by its seams where its file does not say where its pieces hang',
  async (name) => {
    const result = await resultOf(name);
    const nowhere = {translation: [0, 0, 0], rotation: [0, 0, 0]} as const;
    const unplaced: SolveResult = {
      ...result,
      pieces: result.pieces.map((piece) => ({...piece, placement: nowhere})),
    };
    const file = drapeFile(unplaced, await drape(unplaced));
    const limits = {...kept[name], ...(name === 'trousers' ? {sewnLength: 0.06} : {})};
    expect(broken(judgeDrape(file, unplaced), {crossings: 20, ...limits})).toEqual([]);
    expect(file.notes).toContain(
      "The garment's file does not say where its pieces hang; they hang as their seams and names have it.",
    );
  },
);

it('gives the same bytes again, and for pieces in another order those of the same pieces', async () => {
  const result = await resultOf(usual);
  const [one, again] = [await drapeOf(usual), await drape(JSON.stringify(result))];
  expect(drapeText(drapeFile(result, again))).toBe(drapeText(drapeFile(result, one)));
  expect(bytesAlike(glb(result, again, checks), glb(result, one, checks))).toBe(true);

  const last = result.pieces.length - 1;
  const turned = <T extends {readonly piece: number}>(side: T): T => ({
    ...side,
    piece: last - side.piece,
  });
  const other: SolveResult = {
    ...result,
    pieces: result.pieces.toReversed(),
    seams: result.seams.map((seam) => ({...seam, a: turned(seam.a), b: turned(seam.b)})),
    symmetries: result.symmetries.map((symmetry) =>
      symmetry.kind === 'piece'
        ? turned(symmetry)
        : {...symmetry, pieces: [last - symmetry.pieces[0], last - symmetry.pieces[1]]},
    ),
  };
  const {pieces} = drapeFile(other, await drape(other));
  expect(pieces.toReversed()).toEqual(drapeFile(result, one).pieces);
});

it('differs by its texture coordinates alone, where another print leaves the cut as it was', async () => {
  const options = {maxChangeCm: 0};
  const files = [];
  for (const print of [checks, {...checks, w1: [7, 0], w2: [0, 7]} as const]) {
    const result = await solve({garment: garmentOf(usual), print, options});
    const {json, vectors} = readGlb(glb(result, await drape(result), print));
    const {attributes, indices} = at(at(json.meshes, 0).primitives, 0);
    const {TEXCOORD_0: coordinates = -1, ...rest} = attributes;
    files.push({
      coordinates: vectors(coordinates),
      rest: [...Object.values(rest), indices].map(vectors),
    });
  }
  const [one, other] = files;
  expect(other?.rest).toEqual(one?.rest);
  expect(other?.coordinates).not.toEqual(one?.coordinates);
});

/** Limits of the movement at twice the effort, in cm; folds of skirts may differ. */
const moves: readonly (readonly [Sample, {readonly rms: number; readonly max: number}])[] = [
  ['tee', {rms: 0.2, max: 0.8}],
  ['shift-dress', {rms: 0.2, max: 0.8}],
  ['raglan', {rms: 0.2, max: 0.9}], // measured, and rounded up, as below
  ['princess-dress', {rms: 0.3, max: 1.2}],
  ['six-gore-skirt', {rms: 0.6, max: 2.4}],
];

describe.each(sampleOf(1, moves))('%s', (name, most) => {
  it('moves little with more effort, and is near its least energy', async () => {
    const result = await resultOf(name);
    const files: DrapeFile[] = [];
    for (const effort of sampleOf(2, [1, 2, 4] as const))
      files.push(drapeFile(result, await drapeOf(name, effort)));
    const {rms, max} = apart(at(files, 0), at(files, 1));
    expect(rms).toBeLessThan(most.rms);
    expect(max).toBeLessThan(most.max);
    const energies = files.map((file) => restingEnergy(file, result));
    expect(Math.abs(at(energies, 0) / at(energies, energies.length - 1) - 1)).toBeLessThan(0.003);
  });
});

/** Replaces the file's rounded numbers with those in double precision. */
const exactly = (file: DrapeFile, {mesh, positions}: Drape): DrapeFile => ({
  ...file,
  pieces: file.pieces.map((piece, k) => {
    const {shape, sewn} = at(mesh.pieces, k);
    return {
      ...piece,
      shape: piece.shape.map((_, vertex) => {
        const [x = NaN, y = NaN] = shape.subarray(2 * vertex, 2 * vertex + 2);
        return [x, y] as const;
      }),
      positions: Array.from(sewn, (vertex) => {
        const [x = NaN, y = NaN, z = NaN] = positions.subarray(3 * vertex, 3 * vertex + 3);
        return [x, y, z] as const;
      }),
    };
  }),
});

/** Share of the weight of a garment that the form does not bear; the more effort, the less. */
const unborneShares: readonly (readonly [Sample, Effort, number])[] = [
  ['tee', 1, 0.04],
  ['tee', 4, 0.02],
  ['shift-dress', 1, 0.02],
  ['princess-dress', 1, 0.04],
  ['princess-dress', 4, 0.02],
];

it.each(sampleOf(1, unborneShares))(
  'hangs the weight of %s on the form, with effort %i',
  async (name, effort, most) => {
    const result = await resultOf(name);
    const worn = await drapeOf(name, effort);
    expect(unborne(exactly(drapeFile(result, worn), worn), result)).toBeLessThan(most);
  },
);

it('has the seams of its result, without those that close its cuffs', async () => {
  const result = await resultOf('shirt');
  const seen = new AbortController();
  let seams: DrapeMesh['seams'] = [];
  const onMesh = (mesh: DrapeMesh) => {
    ({seams} = mesh);
    seen.abort();
  };
  await expect(drape(result, {}, {onMesh, signal: seen.signal})).rejects.toThrow();
  expect(seams.map(({a, b}) => [a.piece, b.piece])).toEqual(
    result.seams.map(({a, b}) => [a.piece, b.piece]),
  );
});

it('takes forms of other bodies', async () => {
  const {form} = await drapeOf('tee');
  const body = {...form.body, bust: 112, waist: 100};
  const large = await drape(await resultOf('tee'), {body});
  expect(large.form.body).toMatchObject({bust: 112, waist: 100});
  expect(large.check.tension.max).toBeGreaterThan(0.03); // the garment is drafted for 96 cm
});

// the command line tests both in each run
it.runIf(isThorough)('takes forms of other sizes, and other fabrics', async () => {
  const small = await drape(await resultOf('tee'), {size: 'S', fabric: 'jersey'});
  expect(small.form.body).toMatchObject({bust: 88, waist: 72});
  expect(small.fabric.name).toBe('jersey');
});

it.each(isThorough ? (['tee', 'princess-dress'] as const) : [usual])(
  'gives the same bytes for a %s with other names',
  async (name) => {
    const result = await resultOf(name);
    const pieces = result.pieces.map((piece, k) => ({...piece, name: `piece ${100 - k}`}));
    const {positions} = await drape({...result, pieces});
    expect(bytesAlike(positions, (await drapeOf(name)).positions)).toBe(true);
  },
);

it('ends when nobody wants it any more', async () => {
  const stop = new AbortController();
  const onProgress = () => {
    stop.abort();
  };
  const draped = drape(await resultOf('tee'), {}, {signal: stop.signal, onProgress});
  await expect(draped).rejects.toThrow('abort');
});
