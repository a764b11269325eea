/** Histories as browsers store them between two visits. */
import {expect, it} from 'vitest';

import {historyIn, stateOf} from '@/app/projects/open-project.js';
import type {Symmetry} from '@/model/garment/symmetries.js';
import {bareFabric, newDesign} from '@/workbench/samples.js';

const symmetry: readonly Symmetry[] = [{kind: 'piece', piece: 'front'}];
const none = newDesign({name: 'tee.json', text: '{}'}, bareFabric);
const listed = {...none, symmetry, seed: 5};
const history = {
  past: [{design: none, view: null}],
  present: {design: listed, view: {centre: [1, 2], scale: 3}},
  future: [{design: {...none, symmetry: 'auto'}, view: null}],
} as const;

it('are had back as they were', () => {
  expect(historyIn(structuredClone(stateOf(history)))).toEqual(history);
});

it('are kept in the fields that earlier pages read', () => {
  const {past, present} = stateOf(history).history;
  expect(past[0]?.design).toMatchObject({symmetries: []});
  expect(past[0]?.design).not.toHaveProperty('seed');
  expect(present.design).toMatchObject({symmetries: symmetry, seed: 5});
});

it('of an earlier page are read', () => {
  const {garment, print, method, options} = none;
  const step = {design: {garment, print, symmetries: [], method, options}, view: null};
  expect(historyIn({version: 1, history: {past: [], present: step, future: []}})).toEqual({
    ...{past: [], future: []},
    present: {design: none, view: null},
  });
});

it('of a newer page are left alone', () => {
  expect(historyIn({...stateOf(history), version: 2})).toBeUndefined();
});
