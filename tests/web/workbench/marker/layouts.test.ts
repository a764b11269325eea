/** Layouts of a workbench: contents, time, and manual moves. */
import {describe, expect, it, vi} from 'vitest';

import type {Design} from '@/model/design/design.js';
import {SolverError} from '@/model/base/failure.js';
import type {GarmentDocument} from '@/model/garment/garment-document.js';
import type {Alignment} from '@/model/geometry/vectors.js';
import type {
  MarkerAnswer,
  MarkerHooks,
  MarkerLayout,
  MarkerProblem,
} from '@/model/result/marker-search.js';
import type {SolveResult} from '@/model/result/result.js';
import type {SolverService} from '@/solver/service.js';
import {preferencesFor, type Preferences} from '@/texts/preferences.js';
import {storedFabric, withFabric} from '@/workbench/marker/marker-choices.js';
import {Layouts} from '@/workbench/marker/layouts.js';
import {addedFrom} from '@/workbench/marker/garment-steps.js';
import {bareFabric, newDesign} from '@/workbench/samples.js';
import type {Workbench} from '@/workbench/workbench.js';
import {plainMetrics, squarePair} from '../../../support/garments/two-squares.js';

const garment = {name: 'two.json', text: '{}'};
const document = {pieces: [], seams: []} as unknown as GarmentDocument;
const design = newDesign(garment, bareFabric);
const result: SolveResult = {
  ...{format: 'seamwise-result/1', units: 'cm', search: [], metrics: plainMetrics, notes: []},
  ...squarePair(),
};
const other: SolveResult = {...result};

const placed = (x: number, y: number): Alignment => ({angle: 0, translation: [x, y]});
/** Both pieces side by side; the cut lines reach 3 cm below the squares, and 1 cm above them. */
const layout: MarkerLayout = {
  lengthCm: 8,
  printOrigin: [2, 1],
  places: [placed(2, 3), placed(12, 3)],
};
const answer: MarkerAnswer = {
  ...layout,
  ...{boundCm: 8, proven: true, freeLengthCm: 8, notes: []},
  ...{phaseLengthsCm: [], widthLengthsCm: []},
};

interface Asked {
  readonly problem: MarkerProblem;
  readonly hooks: MarkerHooks;
  readonly answer: (given?: Partial<MarkerAnswer>) => void;
  readonly fail: (error: Error) => void;
}

const settled = (): Promise<unknown> => new Promise((resolve) => setTimeout(resolve, 5));

// no pauses, even on a busy machine
vi.mock('@/solver/answers/slices.js', async (original) => ({
  ...(await original<typeof import('@/solver/answers/slices.js')>()),
  besideThePage: {slice: Infinity, pause: () => Promise.resolve()},
}));

function atWork(at: {design: Design | undefined; result: SolveResult | undefined}) {
  const asked: Asked[] = [];
  const marker = vi.fn<SolverService['marker']>(
    (problem, hooks = {}) =>
      new Promise((resolve, reject) => {
        const give: Asked['answer'] = (given = {}) => {
          resolve({...answer, ...given});
        };
        asked.push({problem, hooks, answer: give, fail: reject});
        hooks.signal?.addEventListener('abort', () => {
          reject(new DOMException('', 'AbortError'));
        });
      }),
  );
  const listeners = new Set<() => void>();
  let chosen = preferencesFor('en');
  const solve = {
    answers: [] as ((result: SolveResult) => void)[],
    failures: [] as ((error: Error) => void)[],
    signals: [] as (AbortSignal | undefined)[],
  };
  const solver = {
    marker,
    /** Offers solve again without names; they find nothing here. */
    solve: (_: unknown, {signal, names}: Parameters<SolverService['solve']>[1] = {}) =>
      new Promise<SolveResult>((resolve, reject) => {
        if (!names) {
          reject(new Error('no offers'));
          return;
        }
        solve.answers.push(resolve);
        solve.failures.push(reject);
        solve.signals.push(signal);
        signal?.addEventListener('abort', () => {
          reject(new DOMException('', 'AbortError'));
        });
      }),
  };
  const source = {
    solver: solver as unknown as SolverService,
    preferences: {
      get chosen() {
        return chosen;
      },
    },
    prefer: (change: Partial<Preferences>) => {
      chosen = {...chosen, ...change};
      for (const listener of [...listeners]) listener();
    },
    history: {
      get design() {
        return at.design;
      },
    },
    solving: {
      garment: document,
      documentOf: () => Promise.resolve(document),
      get result() {
        return at.result;
      },
    },
    subscribe: (_: unknown, listener: () => void) => {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
  } as unknown as Workbench;
  const layouts = new Layouts(source);
  return {
    ...{layouts, asked, listeners, source, solve},
    become: (next: Partial<typeof at>) => {
      Object.assign(at, next);
      for (const listener of [...listeners]) listener();
    },
  };
}

/** Creates a layout and waits until it is settled. */
async function laidOut() {
  const work = atWork({design, result});
  const end = work.layouts.show();
  await settled();
  work.asked[0]?.answer();
  await settled();
  return {...work, end};
}

describe('pieces on their fabric', () => {
  it('are laid while somebody looks, and shown as the layouts come', async () => {
    const {layouts, asked, become, listeners} = atWork({design, result: undefined});
    const end = layouts.show();
    await settled();
    expect([layouts.state.kind, asked.length]).toEqual(['waiting', 0]);
    become({result});
    await settled();
    expect(asked[0]?.problem).toMatchObject({widthCm: 140, selvedgeCm: 1, gapCm: 0.2});
    expect(layouts.pieces).toEqual([]);
    asked[0]?.hooks.onLayout?.(layout);
    expect(layouts.pieces.map(({name}) => name)).toEqual(['left_half', 'right_half']);
    expect(layouts.plan).toMatchObject({proven: false});
    asked[0]?.answer();
    await settled();
    expect([layouts.state.kind, layouts.plan?.proven]).toEqual(['done', true]);
    end();
    expect(listeners.size).toBe(0);
    layouts.show();
    await settled();
    expect(asked).toHaveLength(1); // the known layout is reused
  });

  it('are those of the design before until others are laid, and come back with it', async () => {
    const {layouts, asked, become} = await laidOut();
    become({result: undefined});
    expect([layouts.isStale, layouts.state.kind]).toEqual([true, 'waiting']);
    expect(layouts.pieces).toHaveLength(2);
    layouts.move(0, placed(22, 3)); // ignored for a stale layout
    expect(layouts.pieces[0]?.place.translation[0]).toBe(2);
    become({result: other});
    await settled();
    expect([layouts.isStale, layouts.state.kind]).toEqual([true, 'laying']);
    asked[1]?.hooks.onLayout?.(layout);
    expect(layouts.isStale).toBe(false);
    become({result});
    await settled();
    expect([layouts.isStale, layouts.state.kind, asked.length]).toEqual([false, 'done', 2]);
  });

  it('are moved, turned and pinned in steps that can be taken back', async () => {
    const {layouts} = await laidOut();
    expect([layouts.undo(), layouts.isMoved]).toEqual([false, false]);
    layouts.move(1, placed(12, 13));
    layouts.togglePin(1);
    expect(layouts.plan?.lengthCm).toBeCloseTo(18);
    expect(layouts.plan?.boundCm).toBeCloseTo(8);
    expect(layouts.plan?.proven).toBe(false);
    expect([layouts.isMoved, layouts.step?.pins.has(1)]).toEqual([true, true]);
    expect([layouts.undo(), layouts.step?.pins.size, layouts.isMoved]).toEqual([true, 0, true]);
    expect([layouts.undo(), layouts.plan?.proven, layouts.isMoved]).toEqual([true, true, false]);
    expect([layouts.redo(), layouts.isMoved]).toEqual([true, true]);
    layouts.move(0, placed(32, 3));
    expect(layouts.redo()).toBe(false);
  });

  it('stay where they are pinned, on fabric whose print stays, when the rest is packed', async () => {
    const {layouts, asked} = await laidOut();
    expect(asked[0]?.problem.startCm).toBeUndefined();
    layouts.move(1, placed(12, 13));
    layouts.togglePin(1);
    layouts.pack();
    await settled();
    const {problem} = asked[1] ?? {};
    expect(problem).toMatchObject({phasesCm: [2], startCm: layouts.plan?.printOrigin?.[1]});
    expect(problem?.pieces.map(({pin}) => pin)).toEqual([undefined, placed(12, 13)]);
    asked[1]?.answer({places: [placed(2, 13), placed(12, 13)]});
    await settled();
    expect(layouts.isMoved).toBe(false);
    expect(layouts.undo()).toBe(true);
    expect(layouts.isMoved).toBe(true);
  });

  it('are no plan to buy by while one of them is off the fabric', async () => {
    const {layouts} = await laidOut();
    layouts.remove(1);
    expect(layouts.plan).toMatchObject({proven: false, boundCm: 0, freeLengthCm: 8});
    expect(layouts.plan?.unplaced.map(({piece}) => piece)).toEqual(['right_half']);
    layouts.remove(0);
    expect(layouts.plan).toMatchObject({lengthCm: 0, proven: false});
    expect([layouts.undo(), layouts.undo(), layouts.plan?.proven]).toEqual([true, true, true]);
  });

  it('have lengths on other widths of pieces as they lie, or none', async () => {
    const {layouts, asked} = await laidOut();
    layouts.choose({gapCm: 0.3});
    await settled();
    asked[1]?.answer({
      widthLengthsCm: [9, 9, 9, 8, 8, 7],
      phaseLengthsCm: [8, 9, 9, 9, 9, 9, 9, 9],
    });
    await settled();
    const lengths = () => layouts.plan?.widths.map(({lengthCm}) => lengthCm);
    expect(lengths()?.[3]).toBe(layouts.plan?.lengthCm);
    expect(layouts.plan?.notes.join()).toMatch(/where the print starts/);
    layouts.move(1, placed(12, 13));
    expect(layouts.plan).toMatchObject({widths: [], cheaper: [], notes: [], noteDetails: []});
    expect(layouts.plan?.phases).toEqual([{phaseCm: 2, lengthCm: layouts.plan?.lengthCm}]);
    layouts.remove(0);
    expect(layouts.plan?.phases).toEqual([{phaseCm: 2, lengthCm: null}]);
    expect(layouts.step?.plan?.widths).toHaveLength(6);
  });

  it('are those of the fabric that is shown: where a change of it is taken back or given up', async () => {
    const {layouts, asked, source} = await laidOut();
    layouts.choose({gapCm: 1});
    await settled();
    asked[1]?.answer();
    await settled();
    expect([layouts.undo(), layouts.sources.length, layouts.plan?.unplaced]).toEqual([true, 2, []]);
    layouts.choose({widthCm: 90});
    expect([layouts.isAwaited, source.preferences.chosen.cloths]).toMatchObject([true, {}]);
    layouts.move(0, placed(22, 3)); // ignored before the new layout
    layouts.choose({selvedgeCm: 2});
    await settled();
    expect([layouts.isAwaited, layouts.state.kind, layouts.isMoved]).toEqual([
      true,
      'laying',
      false,
    ]);
    layouts.cancel();
    expect([layouts.isAwaited, layouts.state.kind]).toEqual([false, 'done']);
    expect(layouts.choices).toMatchObject({widthCm: 140, selvedgeCm: 1, gapCm: 0.2});
    expect([layouts.redo(), layouts.plan?.widthCm]).toEqual([false, 140]);
    layouts.choose({widthCm: 90});
    await settled();
    asked.at(-1)?.hooks.onLayout?.(layout);
    layouts.cancel();
    expect([layouts.state.kind, layouts.plan?.widthCm]).toEqual(['cancelled', 90]);
  });

  it('are laid on the fabric as it was changed last by whoever comes back to them', async () => {
    const {layouts, asked, end} = await laidOut();
    layouts.choose({widthCm: 90});
    await settled();
    end();
    expect(layouts.state.kind).toBe('waiting');
    layouts.show();
    await settled();
    expect(asked.at(-1)?.problem.widthCm).toBe(90);
    asked.at(-1)?.answer();
    await settled();
    expect([layouts.state.kind, layouts.plan?.widthCm]).toEqual(['done', 90]);
  });

  it('keep in mind around pins what they took without, on the same fabric', async () => {
    const {layouts, asked} = await laidOut();
    expect(layouts.plan).not.toHaveProperty('unpinnedLengthCm');
    layouts.togglePin(1);
    for (const k of [1, 2]) {
      layouts.pack();
      await settled();
      asked[k]?.answer({places: [placed(2, 13), placed(12, 3)], freeLengthCm: 5});
      await settled();
      expect(layouts.plan).toMatchObject({unpinnedLengthCm: 8, freeLengthCm: 8});
      expect(layouts.plan?.lengthCm).toBeCloseTo(18);
    }
    layouts.setFlaws([
      [
        [0, 90],
        [1, 90],
        [1, 91],
      ],
    ]);
    await settled();
    asked[3]?.answer({places: [placed(2, 13), placed(12, 3)], freeLengthCm: 5});
    await settled();
    expect(layouts.plan).toMatchObject({unpinnedLengthCm: null, freeLengthCm: 5});
    layouts.togglePin(1);
    layouts.pack();
    await settled();
    asked[4]?.answer();
    await settled();
    expect(layouts.plan).not.toHaveProperty('unpinnedLengthCm');
  });

  it('keep off flaws, on fabric whose print stays', async () => {
    const {layouts, asked} = await laidOut();
    const flaw = [
      [0, 0],
      [3, 0],
      [3, 3],
    ] as const;
    layouts.setFlaws([flaw]);
    await settled();
    expect(asked[1]?.problem).toMatchObject({flaws: [flaw], phasesCm: [2]});
    expect(layouts.bolt?.flaws).toEqual([flaw]);
  });

  it('say why they cannot lie on a fabric, and lie again where that is taken back', async () => {
    const {layouts, asked} = await laidOut();
    layouts.choose({widthCm: 30});
    await settled();
    const message = 'left_half is too wide.';
    asked[1]?.fail(new SolverError({code: 'options', message}));
    await settled();
    expect(layouts.state).toMatchObject({kind: 'failed', failure: {message}});
    expect(layouts.pieces).toEqual([]);
    layouts.choose({widthCm: 30});
    await settled();
    expect(asked).toHaveLength(2); // this is the current width
    expect([layouts.undo(), layouts.state.kind, layouts.pieces.length]).toEqual([true, 'done', 2]);
    expect([layouts.redo(), layouts.state.kind]).toEqual([true, 'failed']);
  });

  it('are the best so far where somebody has heard enough, or takes one in hand', async () => {
    const {layouts, asked, become} = atWork({design, result});
    layouts.show();
    await settled();
    asked[0]?.hooks.onLayout?.(layout);
    layouts.cancel();
    await settled();
    expect(asked[0]?.hooks.signal?.aborted).toBe(true);
    expect([layouts.state.kind, layouts.pieces.length]).toEqual(['cancelled', 2]);
    become({});
    expect(asked).toHaveLength(1);
    layouts.pack();
    await settled();
    asked[1]?.hooks.onLayout?.(layout);
    layouts.move(0, placed(22, 3));
    expect(asked[1]?.hooks.signal?.aborted).toBe(true);
    asked[1]?.hooks.onLayout?.(layout);
    expect(layouts.pieces[0]?.place).toEqual(placed(22, 3));
  });

  it('have the allowances of cutting files, and are laid anew with others', async () => {
    const {layouts, asked, source} = await laidOut();
    const reach = (k: number): number =>
      Math.min(...(asked[k]?.problem.pieces[0]?.outline.map(([, y]) => y) ?? []));
    expect(reach(0)).toBeCloseTo(-3); // a hem
    source.prefer({allowances: {hemCm: 5}});
    await settled();
    expect(asked).toHaveLength(2);
    expect(reach(1)).toBeCloseTo(-5);
    expect(layouts.choices).toMatchObject({allowanceCm: 1, hemCm: 5});
    asked[1]?.answer();
    await settled();
    source.prefer({theme: 'dark'});
    expect(layouts.undo()).toBe(true);
    expect(source.preferences.chosen.allowances).toEqual({});
    layouts.choose({allowanceCm: 1.5});
    expect(source.preferences.chosen.allowances).toEqual({allowanceCm: 1.5});
    await settled();
    expect(asked).toHaveLength(3);
  });

  it('are as many as garments are cut, of the next design too', async () => {
    const {layouts, asked, become} = await laidOut();
    become({design: {...design, copies: 3}});
    await settled();
    expect(asked[1]?.problem.pieces).toHaveLength(6);
    asked[1]?.answer({places: [...Array(6).keys()].map((k) => placed(10 * k, 3))});
    await settled();
    expect(layouts.sources.filter(({piece}) => piece === 'left_half')).toHaveLength(3);
    become({design}); // as after an undo: the layout from before returns at once
    expect([layouts.sources.length, layouts.state.kind]).toEqual([2, 'done']);
    become({design: {...design, copies: 2}, result: other});
    await settled();
    expect(asked.at(-1)?.problem.pieces).toHaveLength(4);
  });

  it('are those of added garments too, each solved once for the print of the fabric', async () => {
    const {layouts, asked, become, solve} = await laidOut();
    const one = addedFrom(newDesign({name: 'other.json', text: '{"a": 1}'}, bareFabric));
    const inCopies = (copies: number) => one.map((garment) => ({...garment, copies}));
    const added = inCopies(2);
    become({design: {...design, added}});
    await settled();
    expect(layouts.state).toMatchObject({
      kind: 'laying',
      inWork: {name: 'other.json', number: 2, count: 2},
    });
    solve.answers[0]?.(result);
    await settled();
    expect(asked.at(-1)?.problem.pieces.map(({garment: k}) => k)).toEqual([0, 0, 1, 1, 2, 2]);
    asked.at(-1)?.answer({places: [...Array(6).keys()].map((k) => placed(10 * k, 3))});
    await settled();
    expect(layouts.pieces.map((piece) => piece.garment)).toEqual([0, 0, 1, 1, 1, 1]);
    expect(layouts.garments.map(({copies}) => copies)).toEqual([1, 2]);
    become({design: {...design, added: inCopies(1)}});
    await settled();
    expect(asked.at(-1)?.problem.pieces).toHaveLength(4);
    expect(solve.answers).toHaveLength(1);
  });

  it('name the added garment that cannot be solved, and end its solve when cancelled', async () => {
    const {layouts, become, solve} = await laidOut();
    const added = addedFrom(newDesign({name: 'other.json', text: '{"a": 1}'}, bareFabric));
    become({design: {...design, added}});
    await settled();
    layouts.cancel();
    await settled();
    expect([solve.signals[0]?.aborted, layouts.state.kind]).toEqual([true, 'cancelled']);
    layouts.pack();
    become({design: {...design, added: [...added]}});
    await settled();
    solve.failures.at(-1)?.(new SolverError({code: 'outlineOpen', message: 'It is open.'}));
    await settled();
    expect(layouts.state).toMatchObject({
      kind: 'failed',
      failure: {message: 'other.json: It is open.', piece: null},
    });
  });

  it('have offers that stay with the plan while its pieces are moved', async () => {
    const {layouts, asked} = await laidOut();
    layouts.choose({phaseCm: 2});
    await settled();
    asked[1]?.answer({phaseLengthsCm: [8]});
    await settled();
    layouts.move(1, placed(12, 13)); // interrupts the search for offers
    for (let k = 2; k < asked.length; k++) {
      asked[k]?.answer({lengthCm: 5});
      await settled();
    }
    expect(layouts.isMoved).toBe(true);
    expect(layouts.step?.plan?.cheaper.map(({kind, lengthCm}) => [kind, lengthCm])).toEqual([
      ['phase', 5],
      ['shift', 5],
    ]);
    expect([layouts.undo(), layouts.step?.plan?.cheaper.length]).toEqual([true, 2]);
  });

  it('are remembered with their print, the newest last, and no more than can be told apart', () => {
    const {print} = design;
    const chosen = {...storedFabric(print, preferencesFor('en')), widthCm: 115, price: 12};
    const named = (k: number) => ({...print, title: `print ${k}`});
    let preferences = preferencesFor('en');
    for (let k = 0; k < 45; k++) {
      preferences = {...preferences, ...withFabric(named(k), chosen, preferences)};
    }
    expect(Object.keys(preferences.cloths ?? {})).toHaveLength(40);
    expect(storedFabric(named(44), preferences)).toMatchObject({widthCm: 115, price: 12});
    // invalid values are ignored
    const cloths = {[named(1).title]: {widthCm: -3, gapCm: 'x', isOneWay: true}};
    expect(storedFabric(named(1), {...preferences, cloths})).toMatchObject({
      ...{widthCm: 140, gapCm: 0.2, isOneWay: true},
    });
  });

  it('are not looked for any more when nobody looks', async () => {
    const {layouts, asked} = atWork({design, result});
    const end = layouts.show();
    await settled();
    end();
    expect([asked[0]?.hooks.signal?.aborted, layouts.state.kind]).toEqual([true, 'waiting']);
    layouts.show();
    await settled();
    expect(asked).toHaveLength(2);
  });
});
