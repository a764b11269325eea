/** Drapes of a workbench: contents, time, and display in the meantime. */
import {describe, expect, it, vi} from 'vitest';

import type {Design} from '@/model/design/design.js';
import type {Drape, DrapeHooks, DrapeMesh, Form} from '@/model/result/draped-garment.js';
import type {SolveResult} from '@/model/result/result.js';
import type {SolverService} from '@/solver/service.js';
import {Drapes, type DrapesViewer} from '@/workbench/drape/drapes.js';
import type {Workbench} from '@/workbench/workbench.js';
import {bareFabric, newDesign} from '@/workbench/samples.js';
import {plainMetrics, square, squarePair} from '../../../support/garments/two-squares.js';

const garment = {name: 'two.json', text: '{}'};
const design = newDesign(garment, bareFabric);
const result: SolveResult = {
  ...{format: 'seamwise-result/1', units: 'cm', search: [], metrics: plainMetrics, notes: []},
  ...squarePair(),
};
/** The same pieces with other alignments on the print. */
const moved: SolveResult = {
  ...result,
  pieces: result.pieces.map((piece) => ({
    ...piece,
    shape: [...piece.shape],
    alignment: {angle: 1, translation: [3, 4]},
  })),
};
const cutOtherwise: SolveResult = {
  ...result,
  pieces: result.pieces.map((piece) => ({
    ...piece,
    shape: square.map(([x, y]) => [x, 1.01 * y] as const),
  })),
};
const meshOf = (size: number): DrapeMesh => ({pieces: [], seams: [], mirrors: [], size});
const form = {parts: []} as unknown as Form;
const draped = (value: number): Drape =>
  ({form, mesh: meshOf(2), positions: Float64Array.of(value), notes: []}) as unknown as Drape;

interface Asked {
  readonly result: unknown;
  readonly fabric: unknown;
  readonly size: unknown;
  readonly from: unknown;
  readonly hooks: DrapeHooks;
  readonly answer: (drape: Drape) => void;
  readonly fail: (error: Error) => void;
}

/** A workbench with given answers, and a solver whose drapes the test controls. */
function atWork(at: {design: Design | undefined; result: SolveResult | undefined}) {
  const asked: Asked[] = [];
  const drape = vi.fn<SolverService['drape']>(
    (given, {fabric, size, from} = {}, hooks = {}) =>
      new Promise((resolve, reject) => {
        asked.push({result: given, fabric, size, from, hooks, answer: resolve, fail: reject});
        hooks.signal?.addEventListener('abort', () => {
          reject(new DOMException('', 'AbortError'));
        });
      }),
  );
  const listeners = new Set<() => void>();
  const source = {
    solver: {drape} as unknown as SolverService,
    history: {
      get design() {
        return at.design;
      },
    },
    solving: {
      get result() {
        return at.result;
      },
    },
    subscribe: (_: unknown, listener: () => void) => {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
  } as unknown as Workbench;
  const drapes = new Drapes(source);
  const seen: string[] = [];
  const viewer: DrapesViewer = {
    form: () => seen.push('form'),
    mesh: ({size}) => seen.push(`mesh ${size}`),
    clear: () => seen.push('clear'),
    positions: ([value], isFinal) => seen.push(`${isFinal ? 'final' : 'on the way'} ${value}`),
  };
  return {
    ...{drapes, viewer, asked, listeners},
    seen: () => seen.splice(0),
    become: (next: Partial<typeof at>) => {
      Object.assign(at, next);
      for (const listener of [...listeners]) listener();
    },
    settle: () => new Promise((resolve) => setTimeout(resolve)),
  };
}

describe('a garment as it is worn', () => {
  it('is draped while somebody looks, and shown as it comes', async () => {
    const {drapes, viewer, asked, seen, become, settle, listeners} = atWork({
      design,
      result: undefined,
    });
    expect(drapes.state.kind).toBe('waiting');
    const end = drapes.show(viewer);
    expect(asked).toHaveLength(0);
    become({result});
    expect(asked[0]).toMatchObject({result, fabric: 'poplin'});
    const {hooks} = asked[0] ?? {};
    hooks?.onForm?.(form);
    hooks?.onMesh?.(meshOf(1));
    expect(seen()).toEqual(['form']); // shown once it has positions
    hooks?.onPositions?.(Float32Array.of(7));
    expect(seen()).toEqual(['mesh 1', 'on the way 7']);
    asked[0]?.answer(draped(8));
    await settle();
    expect(seen()).toEqual(['form', 'mesh 2', 'final 8']);
    expect(drapes.state.kind).toBe('done');
    end();
    expect(listeners.size).toBe(0);
    // a later viewer gets it at once, without another drape
    drapes.show(viewer);
    expect(seen()).toEqual(['form', 'mesh 2', 'final 8']);
    expect(asked).toHaveLength(1);
  });

  it('stays while a print changes, and hangs anew where pieces are cut otherwise alone', async () => {
    const {drapes, viewer, asked, seen, become, settle} = atWork({design, result});
    drapes.show(viewer);
    asked[0]?.answer(draped(1));
    await settle();
    seen();
    become({design: {...design}, result: undefined});
    become({result: moved});
    expect([asked.length, seen()]).toEqual([1, []]);
    expect(drapes.state.kind).toBe('done');
    become({result: cutOtherwise});
    expect([asked.length, seen()]).toEqual([2, []]); // the old drape stays
    expect(asked[1]?.from).toBe(drapes.drape); // the new one starts from it
    become({result});
    expect(asked[1]?.hooks.signal?.aborted).toBe(true);
    expect(asked).toHaveLength(2); // the known drape is shown
    expect(seen()).toEqual(['form', 'final 1']);
    await settle();
    expect(drapes.state.kind).toBe('done');
  });

  it('hangs on another form on request, until another garment comes', async () => {
    const {drapes, viewer, asked, become, settle} = atWork({design, result});
    drapes.show(viewer);
    asked[0]?.fail(new Error('It is too small.'));
    await settle();
    drapes.drapeOn('L');
    expect(asked.map(({size}) => size)).toEqual([undefined, 'L']);
    become({design: newDesign({...garment}, bareFabric), result: cutOtherwise});
    expect(asked[2]?.size).toBeUndefined();
  });

  it('is not draped any more when nobody looks, another garment comes or somebody stops it', async () => {
    const {drapes, viewer, asked, become, settle} = atWork({design, result});
    const end = drapes.show(viewer);
    end();
    expect(asked[0]?.hooks.signal?.aborted).toBe(true);
    expect(drapes.state.kind).toBe('waiting');
    drapes.show(viewer);
    become({design: newDesign({...garment}, bareFabric), result: undefined});
    expect(asked[1]?.hooks.signal?.aborted).toBe(true);
    become({result: cutOtherwise});
    drapes.cancel();
    expect(asked[2]?.hooks.signal?.aborted).toBe(true);
    await settle();
    expect(drapes.state.kind).toBe('cancelled');
    become({}); // a cancelled drape starts again only on request
    expect(asked).toHaveLength(3);
    drapes.again();
    expect(asked).toHaveLength(4);
  });

  it('shows no other garment where there is one that cannot be draped', async () => {
    const {drapes, viewer, asked, seen, become, settle} = atWork({design, result});
    drapes.show(viewer);
    asked[0]?.answer(draped(1));
    await settle();
    become({result: cutOtherwise});
    asked[1]?.fail(new Error('It broke.'));
    await settle();
    expect(seen()).toEqual(['form', 'mesh 2', 'final 1']);
    become({design: newDesign({...garment}, bareFabric), result: moved});
    expect(seen()).toEqual([]);
    asked[2]?.fail(new Error('It has no place.'));
    await settle();
    expect(seen()).toEqual(['clear']);
    expect(drapes.drape).toBeUndefined();
  });

  it('says what went wrong, once, and is tried again with another fabric', async () => {
    const {drapes, viewer, asked, become, settle} = atWork({design, result});
    drapes.show(viewer);
    asked[0]?.fail(new Error('The file does not say where the pieces hang.'));
    await settle();
    expect(drapes.state).toMatchObject({
      kind: 'failed',
      failure: {message: 'The file does not say where the pieces hang.'},
    });
    become({});
    expect(asked).toHaveLength(1);
    become({design: {...design, fabric: 'denim'}});
    expect(asked[1]?.fabric).toBe('denim');
    asked[1]?.answer(draped(1));
    await settle();
    expect(drapes.state.kind).toBe('done');
  });
});
