/** Parts of a workbench: a component is only updated for changes of the parts it reads. */
import {ReactiveElement, type PropertyValues} from 'lit';
import {afterEach, beforeEach, expect, it, vi} from 'vitest';

import {WorkbenchElement} from '@/editor/base/workbench-element.js';
import {seamRows} from '@/workbench/lists/rows.js';
import {begun} from '@/model/design/history.js';
import type {SolveHooks} from '@/model/design/solve-problem.js';
import type {SolveResult} from '@/model/result/result.js';
import type {SolverService, TextService} from '@/solver/service.js';
import {preferencesFor} from '@/texts/preferences.js';
import {textsOf} from '@/texts/texts.js';
import {Observable} from '@/workbench/observable.js';
import {bareFabric, newDesign} from '@/workbench/samples.js';
import {Workbench, type WorkbenchParts} from '@/workbench/workbench.js';
import {plainMetrics, squarePair} from '../../support/garments/two-squares.js';

const names = [
  ...['preferences', 'notices', 'selection', 'sheet'],
  ...['history', 'running', 'solving', 'afterwards'],
] as readonly (keyof WorkbenchParts)[];

const design = newDesign({name: 'two.json', text: '{}'}, bareFabric);
const result: SolveResult = {
  ...{format: 'seamwise-result/1', units: 'cm', search: [], metrics: plainMetrics, notes: []},
  ...squarePair(),
};

beforeEach(() => {
  vi.useFakeTimers();
});
afterEach(() => {
  vi.useRealTimers();
});

function atWork() {
  let hooks: SolveHooks = {};
  let answer: ((result: SolveResult) => void) | undefined;
  const solver = {
    solve: (_, given = {}) => {
      hooks = given;
      return new Promise((resolve) => {
        answer = resolve;
      });
    },
  } as Pick<SolverService, 'solve'> as TextService;
  const lease = {solver, release: () => undefined, warm: () => undefined};
  const workbench = new Workbench(lease, preferencesFor('en'));
  workbench.solving.isEdited = false;
  const called: (keyof WorkbenchParts)[] = [];
  for (const name of names) workbench.subscribe([name], () => called.push(name));
  return {
    workbench,
    progress: (fraction: number) => hooks.onProgress?.({phase: 'alignment', fraction}),
    partial: () => hooks.onPartial?.(new Float64Array(6)),
    pattern: () => {
      const {pieces, ...rest} = squarePair();
      const meshed = pieces.map((piece) => ({...piece, edges: [0, 1, 2, 3]}));
      hooks.onPattern?.({...rest, pieces: meshed, fitRandom: 1, notes: []});
    },
    answer: () => answer?.(result),
    called: async () => {
      await vi.advanceTimersByTimeAsync(150);
      return new Set(called.splice(0));
    },
  };
}

it('tells of the progress of a solve whoever shows that, and nobody else', async () => {
  const {workbench, progress, partial, called} = atWork();
  workbench.history.begin(begun({design, view: null}));
  expect(await called()).toEqual(new Set(['history', 'running', 'solving']));
  for (const fraction of [0.1, 0.2, 0.3]) progress(fraction);
  partial();
  expect(await called()).toEqual(new Set(['running']));
  expect(workbench.running.progress.fraction).toBe(0.3);
  expect(workbench.running.partial).toHaveLength(2);
});

it('tells of what is pointed at and said, and of preferences, each by itself', async () => {
  const {workbench, called} = atWork();
  workbench.history.begin(begun({design, view: null}));
  await called();
  workbench.selection.point({kind: 'piece', piece: 0});
  expect(await called()).toEqual(new Set(['selection']));
  workbench.notices.say({tone: 'info', text: 'Done.'});
  expect(await called()).toEqual(new Set(['notices']));
  workbench.prefer({scale: 'paper'});
  expect(await called()).toEqual(new Set(['preferences']));
});

it('tells who follows several parts once of a change of all of them', async () => {
  const {workbench, answer, pattern, called} = atWork();
  const seen: string[] = [];
  workbench.subscribe(['history', 'solving', 'running', 'notices'], () => {
    seen.push(`${workbench.solving.state.kind} ${workbench.solving.result ? 'answered' : 'open'}`);
  });
  workbench.history.begin(begun({design, view: null}));
  expect(seen).toEqual(['solving open']);
  pattern();
  answer();
  await called();
  expect(seen.at(-1)).toBe('done answered');
  seen.length = 0;
  workbench.notices.say({tone: 'info', text: 'Done.'});
  workbench.history.change({options: {maxChangeCm: 0.2}});
  expect(seen).toEqual(['done answered', 'solving open']);
  workbench.history.undo();
  expect(seen.at(-1)).toBe('done answered');
  expect(seen).toHaveLength(3);
});

const {update: updateUnrendered} = ReactiveElement.prototype as unknown as {
  readonly update: (this: ReactiveElement, changed: PropertyValues) => void;
};

/** An editor component without a document; its reads replace rendering. */
class Part extends WorkbenchElement {
  updates = 0;
  reads: (workbench: Workbench) => unknown = () => undefined;

  override get isConnected(): boolean {
    return true;
  }

  protected override createRenderRoot(): HTMLElement {
    return this;
  }

  protected override update(changed: PropertyValues<this>): void {
    updateUnrendered.call(this, changed);
    this.updates++;
    this.reads(this.workbench);
  }
}
customElements.define('test-part', Part);

it('draws a part again when what it has read last may be another, and not otherwise', async () => {
  const {workbench, progress, pattern, called} = atWork();
  workbench.history.begin(begun({design, view: null}));
  pattern();
  await called();
  const [list, bar] = [new Part(), new Part()];
  const texts = textsOf('en');
  list.reads = (of) => [seamRows(of, texts), of.solving.state.kind, of.selection.selected];
  bar.reads = (of) => of.solving.state.kind === 'solving' && of.running.progress;
  for (const part of [list, bar]) {
    part.workbench = workbench;
    part.connectedCallback();
    await part.updateComplete;
  }
  const updates = async (): Promise<readonly number[]> => {
    await called();
    return [list, bar].map((part) => part.updates);
  };
  const [lists = 0, bars = 0] = await updates();
  progress(0.4);
  expect(await updates()).toEqual([lists, bars + 1]);
  workbench.selection.select({kind: 'piece', piece: 1});
  expect(await updates()).toEqual([lists + 1, bars + 1]);
  workbench.solving.cancel();
  expect(await updates()).toEqual([lists + 2, bars + 2]);
  // a cancelled solve shows no further progress
  progress(0.5);
  expect(await updates()).toEqual([lists + 2, bars + 2]);
  list.disconnectedCallback();
  workbench.selection.select(undefined);
  expect(await updates()).toEqual([lists + 2, bars + 2]);
});

it('notes what is read of while it is asked to', () => {
  const {workbench} = atWork();
  workbench.history.begin(begun({design, view: null}));
  const count = (act: () => unknown): number => Observable.readBy(() => void act()).size;
  expect(count(() => undefined)).toBe(0);
  expect(count(() => workbench.history.design)).toBe(1);
  expect(count(() => [workbench.selection.selected, workbench.selection.pointed])).toBe(1);
  expect(count(() => seamRows(workbench, textsOf('en')))).toBe(3);
  workbench.subscribe(['selection'], () => [workbench.history.design, workbench.notices.notice]);
  const pointing = (): void => {
    workbench.selection.point({kind: 'piece', piece: 0});
  };
  expect(count(pointing)).toBe(1); // the selection, not what its listener reads
});

it('keeps its answer, and how long that was looked for, when it is made of another fabric', async () => {
  const {workbench, pattern, answer} = atWork();
  const options = {...design.options, effort: 4};
  workbench.history.begin(begun({design: {...design, options}, view: null}));
  pattern();
  answer();
  await vi.waitFor(() => {
    expect(workbench.solving.result).toBe(result);
  });
  workbench.history.change({fabric: 'denim'});
  expect(workbench.solving.state.kind).toBe('done');
  expect(workbench.solving.result).toBe(result);
  expect(workbench.history.design).toMatchObject({fabric: 'denim', options});
  workbench.history.undo();
  expect(workbench.history.design?.fabric).toBeUndefined();
  workbench.dispose();
});
