import {describe, expect, it, vi} from 'vitest';

import {Proving} from '@/workbench/findings.js';
import type {Design} from '@/model/design/design.js';
import type {SolveResult} from '@/model/result/result.js';
import type {SolverService} from '@/solver/service.js';
import {plainMetrics, squarePair} from '../../support/garments/two-squares.js';

const design: Design = {
  garment: {name: 'two.json', text: '{}'},
  print: {
    ...{title: '', group: 'p1', turnDeg: 0, oneWay: false, cell: 'primitive', image: ''},
    size: {width: 10, height: 10, angleDeg: 90},
  },
  ...{symmetry: 'none', seed: 1, method: 'best', options: {}},
};

const result = (metrics: Partial<SolveResult['metrics']> = {}): SolveResult => ({
  ...{format: 'seamwise-result/1', units: 'cm', search: [], notes: []},
  metrics: {...plainMetrics, searchBound: 0.2, searchCost: 50, ...metrics},
  ...squarePair(),
});

/** A solver that proves these bounds one after the other, for an alignment of cost `searchCost`. */
function provingSolver(bounds: readonly number[], searchCost = 50) {
  const prove = vi.fn<SolverService['prove']>((_, {signal, onProof} = {}) => {
    for (const bound of bounds) onProof?.({bound, searchCost});
    if (signal?.aborted) return Promise.reject(new Error('stopped'));
    return Promise.resolve({bound: bounds.at(-1) ?? 0, searchCost});
  });
  return {service: {prove} as unknown as SolverService, prove};
}

function following(solver: SolverService) {
  let changes = 0;
  const proving = new Proving(solver, () => (changes += 1));
  return {proving, changes: () => changes};
}

describe('what is proven when nothing else is to be done', () => {
  it('is told by the per cent, and known from then on', async () => {
    const {service, prove} = provingSolver([0.301, 0.302, 0.31, 0.9999, 1]);
    const {proving, changes} = following(service);
    await proving.follow(design, result());
    expect(proving.of(design)).toBe(1);
    expect(changes()).toBe(3);
    await proving.follow(design, result());
    expect(prove).toHaveBeenCalledTimes(1);
  });

  it('is never less than what the result says itself', async () => {
    const {service} = provingSolver([0.1]);
    const {proving} = following(service);
    await proving.follow(design, result());
    expect(proving.of(design)).toBe(0.2);
  });

  it('is not asked for where all is proven, or where nothing was searched', async () => {
    const {service, prove} = provingSolver([1]);
    const {proving} = following(service);
    await proving.follow(design, result({searchBound: 1}));
    await proving.follow(design, result({method: 'paper', searchBound: 0}));
    expect(prove).not.toHaveBeenCalled();
  });

  it('holds for the placing of the result, whichever was looked into', async () => {
    const {service} = provingSolver([0.9], 25);
    const {proving} = following(service);
    await proving.follow(design, result());
    expect(proving.of(design)).toBe(0.45);
  });

  it('calls a placing the best that costs next to nothing more', async () => {
    const {service} = provingSolver([0.9, 1], 49.96);
    const {proving} = following(service);
    await proving.follow(design, result());
    expect(proving.of(design)).toBe(1);
  });

  it('stops when something else is to be done, and then goes on', async () => {
    const {service, prove} = provingSolver([0.5]);
    const {proving} = following(service);
    const followed = proving.follow(design, result());
    proving.stop();
    await followed;
    await proving.follow(design, result());
    expect(prove).toHaveBeenCalledTimes(2);
    expect(proving.of(design)).toBe(0.5);
  });
});
