/** A photo on its way to a print, without a page: readings, corrections, lengths, and undo. */
import {groupNames} from '@/model/base/core-tables.js';
import {describe, expect, it, vi} from 'vitest';

import {brokenPath, brokenPlaces} from '@/photo/breaks-on-photo.js';
import {boxOf, cellLines, movedNode, nodesOf} from '@/photo/lattice-lines.js';
import {PhotoSession} from '@/workbench/photo/photo-session.js';

import {
  cellOf,
  conflictIn,
  groupOf,
  isDoubtful,
  measuresOf,
  scaledStep,
  stepOf,
  tileSettings,
} from '@/photo/photo-step.js';
import {axesOf, centresOf, marksOn} from '@/photo/symmetry-marks.js';
import {gainsFor} from '@/photo/white-spot.js';
import {norm} from '@/model/geometry/vectors.js';
import {SolverError} from '@/model/base/failure.js';
import {pixelOf, rebased, vectorsAtMiddle} from '@/model/print/photo-map.js';
import {type GroupName} from '@/model/print/repeating-print.js';
import type {
  PhotoHooks,
  PhotoMap,
  PhotoObject,
  PhotoObjectRequest,
  PhotoReading,
  PhotoRequest,
  PhotoTileRequest,
} from '@/model/print/photo-reading.js';
import {balance} from '@/solver/answers/photo.js';
import type {SolverService} from '@/solver/service.js';

const size = {width: 900, height: 600};

/** Cells of 100 x 80 px in perspective. */
const map: PhotoMap = {homography: [100, 10, 420, 8, -80, 310, 1e-2, -2e-2, 1], lens: 0.01};

const read = (group: GroupName, of = map, more: Partial<PhotoReading> = {}): PhotoReading => ({
  ...size,
  map: of,
  ...vectorsAtMiddle(of, size),
  ...{w1: null, w2: null, group},
  shape: [
    [1, 0],
    [0, 0.8],
  ],
  groups: groupNames.map((name) => ({
    ...{name, rho: name === group ? 0 : 0.3, worst: 0.1, map: of},
    verdict: name === group || name === 'p1' ? 'has' : name === 'p6m' ? 'cannot' : 'has not',
  })),
  ...{confidence: 'sure', latticeUncertainty: 0.001, oneWay: false, stripes: false},
  ...{copies: 30, explained: 0.95, others: [], differing: [], notes: []},
  seen: {aspect: 1, error: 0.03},
  ...more,
});

const picture = new Blob([new Uint8Array(64)]);

/** A solver that records requests, answered by the test. */
function solver() {
  const asked: {
    request: PhotoRequest;
    answer: (reading: PhotoReading) => void;
    fail: (e: Error) => void;
  }[] = [];
  const tiles: PhotoTileRequest[] = [];
  const objects: PhotoObjectRequest[] = [];
  return {
    ...{asked, tiles, objects},
    photo: (request: PhotoRequest, {signal}: {signal?: AbortSignal} = {}) =>
      new Promise<PhotoReading>((answer, fail) => {
        asked.push({request, answer, fail});
        signal?.addEventListener('abort', () => {
          fail(signal.reason as Error);
        });
      }),
    photoObject: (request: PhotoObjectRequest) => {
      objects.push(request);
      const {object, at} = request;
      if (at[0] < 100) {
        return Promise.reject(new SolverError({code: 'picture', message: 'No coin is seen.'}));
      }
      const between = {from: pixelOf(map, size, [0, 0]), to: pixelOf(map, size, [1, 0]), cm: 2.325};
      return Promise.resolve({object, outline: [at, between.from, between.to], between, error: 0});
    },
    photoTile: (request: PhotoTileRequest) => {
      tiles.push(request);
      return Promise.resolve({width: 2, height: 2, data: new Uint8ClampedArray(16)});
    },
  };
}

async function opened(
  reading = read('pmm'),
  more: Partial<Pick<SolverService, 'photoObject'>> = {},
) {
  const made = {...solver(), ...more};
  const session = new PhotoSession(made, picture);
  void session.begin();
  await vi.waitFor(() => {
    expect(made.asked).toHaveLength(1);
  });
  made.asked[0]?.answer(reading);
  await vi.waitFor(() => {
    expect(session.state.kind).toBe('done');
  });
  return {...made, session};
}

describe('a session', () => {
  it('reads the picture, and mends the lattice that somebody moved as a step of its own', async () => {
    const {session, asked} = await opened();
    expect(session.step && groupOf(session.step)).toBe('pmm');
    const moved = movedNode(map, size, [0, 0], [1, 0], [530, 330]);
    void session.align(moved);
    await vi.waitFor(() => {
      expect(asked).toHaveLength(2);
    });
    expect(asked[1]?.request).toMatchObject({lattice: moved, picture});
    expect(asked[1]?.request).not.toHaveProperty('keepsLattice');
    expect(session.step?.isByHand).toBe(false);
    asked[1]?.answer(read('p2', moved));
    await vi.waitFor(() => {
      expect(session.step?.reading.map).toEqual(moved);
    });
    expect(session.step?.isByHand).toBe(true);
    expect(session.undo()).toBe(true);
    expect(session.step?.reading.map).toEqual(map);
    expect(session.redo()).toBe(true);
    expect(session.step?.reading.group).toBe('p2');
    expect(session.redo()).toBe(false);
  });

  it('keeps what was read when a correction is ended or fails, and says why', async () => {
    const {session, asked} = await opened();
    void session.align(map, true);
    await vi.waitFor(() => {
      expect(asked).toHaveLength(2);
    });
    expect(asked[1]?.request.keepsLattice).toBe(true);
    session.cancel();
    expect(session.state.kind).toBe('done');
    expect(session.canUndo).toBe(false);
    void session.align(map);
    await vi.waitFor(() => {
      expect(asked).toHaveLength(3);
    });
    asked[2]?.fail(new SolverError({code: 'picture', message: 'No repeat was found.'}));
    await vi.waitFor(() => {
      expect(session.state).toMatchObject({
        kind: 'failed',
        failure: {message: 'No repeat was found.'},
      });
    });
    expect(session.step?.reading.group).toBe('pmm');
  });

  it('makes a tile once for what decides about it, and another for another light', async () => {
    const {session, tiles} = await opened();
    await Promise.all([session.tile(), session.tile()]);
    session.change({quarterTurns: 1});
    await session.tile();
    expect(tiles).toHaveLength(1);
    session.change({flatten: 0.5, isExact: true});
    await session.tile();
    expect(tiles).toHaveLength(2);
    expect(tiles[1]).toMatchObject({flatten: 0.5, symmetrise: 'pmm'});
  });
});

describe('a coin', () => {
  it('makes the size known instead of the tape, as a step that can be undone', async () => {
    const {session, objects} = await opened();
    session.measure('w1', {repeats: 10, cm: 80});
    await session.measureBy('eur1', [400, 300]);
    expect(objects[0]).toMatchObject({object: 'eur1', at: [400, 300], shape: read('pmm').shape});
    const {step} = session;
    if (!step) throw new Error('Nothing was read.');
    expect(step.w1Measured).toBeUndefined();
    expect(measuresOf(step).size.width).toBeCloseTo(2.325, 3);
    const half = scaledStep(step, {width: 450, height: 300});
    expect(measuresOf(half).size.width).toBeCloseTo(2.325, 3);
    expect(half.object?.outline[0]).toEqual([200, 150]);
    session.undo();
    expect(session.step?.object).toBeUndefined();
    expect(session.step && measuresOf(session.step).size.width).toBeCloseTo(8, 3);
  });

  it('is looked for with progress, and given up at once, with what was measured before', async () => {
    const searches: (PhotoHooks & {answer: (object: PhotoObject) => void})[] = [];
    const {session} = await opened(read('pmm'), {
      photoObject: (_, hooks = {}) =>
        new Promise((answer) => {
          searches.push({...hooks, answer});
        }),
    });
    session.measure('w1', {repeats: 10, cm: 80});
    const {step} = session;
    const searched = session.measureBy('eur1', [400, 300]);
    expect(session.search).toEqual({kind: 'looking', stage: 'object', fraction: 0});
    searches[0]?.onProgress?.({stage: 'object', fraction: 0.4});
    expect(session.search).toEqual({kind: 'looking', stage: 'object', fraction: 0.4});
    session.cancelSearch();
    expect(searches[0]?.signal?.aborted).toBe(true);
    expect(session.search.kind).toBe('none');
    searches[0]?.onProgress?.({stage: 'object', fraction: 0.5});
    const at = pixelOf(map, size, [0, 0]);
    const between = {from: at, to: at, cm: 1};
    searches[0]?.answer({object: 'eur1', outline: [at], between, error: 0});
    await searched;
    expect(session.search.kind).toBe('none');
    expect(session.step).toBe(step);
  });

  it('is not looked for any more once the lattice is another', async () => {
    const signals: (AbortSignal | undefined)[] = [];
    const {session} = await opened(read('pmm'), {
      photoObject: (_, {signal} = {}) => {
        signals.push(signal);
        return new Promise(() => undefined);
      },
    });
    void session.measureBy('eur1', [400, 300]);
    void session.align(map);
    expect(signals[0]?.aborted).toBe(true);
  });

  it('that is not seen changes nothing, and is said until something else is done', async () => {
    const {session} = await opened();
    await session.measureBy('eur1', [50, 300]);
    expect(session.search).toMatchObject({kind: 'failed', failure: {message: 'No coin is seen.'}});
    expect(session.canUndo).toBe(false);
    session.change({quarterTurns: 1});
    expect(session.search.kind).toBe('none');
  });
});

describe('white balance', () => {
  it('makes grey what was tinted, as bright as it was', () => {
    const [red, green, blue] = gainsFor([200, 180, 150, 255]);
    const tile = new Uint8ClampedArray([200, 180, 150, 255, 0, 0, 0, 255]);
    balance(tile, [red, green, blue]);
    expect(Math.max(...tile.subarray(0, 3)) - Math.min(...tile.subarray(0, 3))).toBeLessThan(2);
    expect(Array.from(tile.subarray(3))).toEqual([255, 0, 0, 0, 255]);
    expect(red).toBeLessThan(1);
    expect(blue).toBeGreaterThan(1);
  });

  it('is of the tile, not of the reading', async () => {
    const {session, tiles} = await opened();
    session.change({gains: [0.9, 1, 1.2]});
    await session.tile();
    expect(tiles[0]).toMatchObject({gains: [0.9, 1, 1.2]});
  });
});

describe('where a symmetry is broken', () => {
  const one = {x: 0.25, y: 0.5, width: 0.25, height: 0.25, difference: 40};
  const rows = [one, {...one, x: 0.5}];

  it('is on every cell', () => {
    const {rings, steps} = brokenPlaces(rows, {group: 'pmm', cell: 'primitive'});
    expect(rings).toEqual([
      [
        [0.25, 0.5],
        [0.75, 0.5],
        [0.75, 0.25],
        [0.25, 0.25],
      ],
    ]);
    const path = brokenPath(map, size, {rings, steps});
    const at = pixelOf(map, size, [1.25, 0.5]).map((one) => one.toFixed(1));
    expect(path).toContain(`M${at.join(' ')}L`);
    expect(path.split('Z').length).toBeGreaterThan(25);
  });

  it.each([
    ['cmm', [-0.25, 1.25]],
    ['p6m', [-0.25, 1.5]],
  ] as const)('is in lattice coordinates of %s, from the rectangle that is shown', (group, at) => {
    const [ring] = brokenPlaces([{...one, x: 0.5, y: 0.25}], {group, cell: 'rectangular'}).rings;
    expect(ring?.[0]).toEqual(at);
  });
});

describe('the print', () => {
  const step = stepOf(read('pmm'));

  it('is of unknown size until a length is measured, along either vector or between two points', () => {
    expect(measuresOf(step)).toMatchObject({unscaled: true, size: {width: 10, height: 8}});
    const tape = {repeats: 10, cm: 62.5};
    expect(measuresOf({...step, w1Measured: tape})).toMatchObject({size: {width: 6.25, height: 5}});
    expect(measuresOf({...step, w1Measured: tape})).not.toHaveProperty('unscaled');
    expect(measuresOf({...step, w2Measured: tape}).size.height).toBeCloseTo(6.25, 3);
    const both = {...step, w1Measured: tape, w2Measured: {repeats: 4, cm: 20.4}};
    expect(measuresOf(both).size).toMatchObject({width: 6.25, height: 5.1});
    // three repeats across and two up, in the photo's directions
    const between = {from: pixelOf(map, size, [-1, 1]), to: pixelOf(map, size, [2, -1]), cm: 17};
    expect(measuresOf({...step, between}).size.width).toBeCloseTo(17 / Math.hypot(3, 1.6), 3);
  });

  it('has the vectors of the group that somebody chooses, and says when lengths do not fit it', () => {
    const reading = read('pmm', map, {
      shape: [
        [1, 0],
        [0, 1],
      ],
    });
    // the rhombic cell of the same lattice twice as fine: its vectors are half diagonals
    const rhombic = rebased(map, [
      [0.5, -0.5],
      [0.5, 0.5],
    ]);
    const groups = reading.groups.map((one) => (one.name === 'cmm' ? {...one, map: rhombic} : one));
    const chosen = {...stepOf({...reading, groups}), chosen: 'cmm' as const};
    expect(cellOf(chosen).w1[0]).toBeCloseTo(0.5, 9);
    expect(cellOf(chosen).w1[1]).toBeCloseTo(-0.5, 9);
    expect(measuresOf(chosen)).toMatchObject({cell: 'rectangular', size: {width: 10, height: 10}});
    expect(tileSettings(chosen).map).toBe(rhombic);
    const measured = {...chosen, w1Measured: {repeats: 1, cm: 11}};
    expect(conflictIn(measured)).toBeUndefined();
    // below the error of a tape measure
    const both = {...measured, w2Measured: {repeats: 1, cm: 11.02}};
    expect(conflictIn(both)).toBeUndefined();
    expect(norm(cellOf(both).w1)).toBeCloseTo(11.01, 3);
    expect(norm(cellOf(both).w2)).toBeCloseTo(11.01, 3);
    // w1 determines both
    const apart = {...measured, w2Measured: {repeats: 1, cm: 11.2}};
    expect(conflictIn(apart)).toMatchObject({w1: 11, w2: 11.2, isOfGroup: true});
    expect(conflictIn(apart)?.share).toBeCloseTo(0.2 / 11, 9);
    expect(norm(cellOf(apart).w2)).toBeCloseTo(11, 9);
    expect(measuresOf(apart)).toMatchObject({size: measuresOf(measured).size});
    expect(measuresOf({...apart, w1Measured: undefined}).size.width).toBeCloseTo(
      11.2 * 2 ** 0.5,
      3,
    );
  });

  it('says when lengths are not as the photograph shows them, and takes both', () => {
    const of = (repeats: number, error = 0.03) => ({
      ...stepOf(read('pmm', map, {seen: {aspect: 1, error}})),
      w1Measured: {repeats: 10, cm: 100},
      w2Measured: {repeats, cm: 80},
    });
    expect(conflictIn(of(10))).toBeUndefined();
    expect(conflictIn(of(9))).toMatchObject({w1: 10, isOfGroup: false});
    expect(conflictIn(of(9))?.expected).toBeCloseTo(8, 9);
    expect(conflictIn(of(9))?.share).toBeCloseTo(1 / 9, 9);
    expect(cellOf(of(9)).w2[1]).toBeCloseTo(80 / 9, 9);
    // proportions are less certain with an unknown camera
    expect(conflictIn(of(9, 0.15))).toBeUndefined();
    expect(conflictIn(of(1, 0.15))?.share).toBeCloseTo(9, 9);
  });

  it('is doubtful until somebody places the cell, or chooses the group', () => {
    const uncertain = stepOf(read('pmm', map, {confidence: 'uncertain'}));
    expect(isDoubtful(uncertain)).toBe(true);
    expect(isDoubtful(stepOf(read('pmm', map, {confidence: 'likely'})))).toBe(false);
    expect(isDoubtful({...uncertain, chosen: 'p2'})).toBe(false);
    expect(isDoubtful(stepOf(uncertain.reading, uncertain, {isByHand: true}))).toBe(false);
    expect(isDoubtful(stepOf(uncertain.reading, {...uncertain, isByHand: true}))).toBe(true);
  });

  it('keeps a chosen group over the next reading, unless that lattice cannot have it', () => {
    const chosen = {...step, chosen: 'p2' as const};
    expect(stepOf(read('p1'), chosen).chosen).toBe('p2');
    expect(stepOf(read('p1'), {...step, chosen: 'p6m'}).chosen).toBeUndefined();
  });

  it('lies on a smaller copy of its photograph as on the photograph itself', () => {
    const between = {from: [90, 60], to: [450, 300], cm: 17} as const;
    const half = scaledStep({...step, between}, {width: 450, height: 300});
    expect(measuresOf(half)).toEqual(measuresOf({...step, between}));
    expect(pixelOf(half.reading.map, half.reading, [2, 1])[0]).toBeCloseTo(
      pixelOf(map, size, [2, 1])[0] / 2,
      6,
    );
  });

  it('turns by quarters, up to 180 degrees', () => {
    const turns = [0, 1, 2, 3].map((quarterTurns) => measuresOf({...step, quarterTurns}).turnDeg);
    expect(turns).toEqual([0, 90, 180, -90]);
  });
});

describe('the lattice over the photograph', () => {
  it('follows a node that is moved: its place is where it was put, and the base stays', () => {
    const base = [1, 2] as const;
    for (const node of [
      [2, 2],
      [1, 3],
      [4, -1],
    ] as const) {
      const moved = movedNode(map, size, base, node, [333, 222]);
      pixelOf(moved, size, node).forEach((value, k) => {
        expect(value).toBeCloseTo([333, 222][k] ?? 0, 3);
      });
      expect(pixelOf(moved, size, base)[0]).toBeCloseTo(pixelOf(map, size, base)[0], 3);
    }
    const shifted = movedNode(map, size, base, base, [333, 222]);
    expect(pixelOf(shifted, size, base)[1]).toBeCloseTo(222, 3);
  });

  it('shows all of the picture, and nodes that lie on it', () => {
    const {least, most} = boxOf(map, size);
    expect(least[0]).toBeLessThan(-3);
    expect(most[1]).toBeGreaterThan(2);
    const lines = most[0] - least[0] + 1 + (most[1] - least[1] + 1);
    expect(cellLines(map, size).split('M').length - 1).toBe(lines);
    const nodes = nodesOf(map, size);
    expect(nodes.length).toBeGreaterThan(20);
    expect(nodes.every((node) => pixelOf(map, size, node)[0] <= size.width)).toBe(true);
  });

  /** Mirrors, glides, and rotation centres in one cell, by the International Tables. */
  it.each([
    ['p1', 0, 0, ''],
    ['p2', 0, 0, '2222'],
    ['pm', 2, 0, ''],
    ['pg', 0, 2, ''],
    ['cm', 1, 1, ''],
    ['pmm', 4, 0, '2222'],
    ['pgg', 0, 4, '2222'],
    ['p4', 0, 0, '2244'],
    ['p4m', 6, 2, '2244'],
    ['p4g', 2, 6, '2244'],
    ['p3', 0, 0, '333'],
    ['p6', 0, 0, '222336'],
    ['p6m', 6, 6, '222336'],
  ] as const)('marks the symmetries of %s', (group, mirrors, glides, orders) => {
    const axes = axesOf(group);
    expect(axes.filter(({isMirror}) => isMirror)).toHaveLength(mirrors);
    expect(axes.filter(({isMirror}) => !isMirror)).toHaveLength(glides);
    const found = centresOf(group).map(({order}) => order);
    expect(found.sort().join('')).toBe(orders);
    expect(marksOn(group, map, size).mirrors !== '').toBe(mirrors > 0);
  });
});
