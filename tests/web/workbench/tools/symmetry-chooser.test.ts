/** Choices and refusals after a change of the design, in particular by undo. */
import {expect, it, vi} from 'vitest';

import type {Choice} from '@/clicks/symmetry-tool.js';
import {SymmetryChooser} from '@/workbench/tools/symmetry-chooser.js';
import {en} from '@/texts/en.js';
import {formatFor} from '@/texts/format.js';
import type {Workbench} from '@/workbench/workbench.js';
import type {Design} from '@/model/design/design.js';
import type {PatternScene} from '@/scene/scene.js';
import {sewnSquares} from '../../../support/clickable-sheet.js';

const design = {garment: {name: 'a.json', text: '{}'}} as Design;
const format = formatFor('en', 'cm');

/** A workbench that shows two squares. */
function chooserAt(): {
  readonly chooser: SymmetryChooser;
  readonly show: (design: Design) => void;
  readonly words: () => string;
} {
  const workbench = {
    history: {design},
    solving: {kept: [], measure: vi.fn()},
    sheet: {scenes: {now: sewnSquares()}},
  };
  const chooser = new SymmetryChooser(workbench as unknown as Workbench, () => undefined);
  return {
    chooser,
    show: (next) => {
      workbench.history.design = next;
    },
    words: () => chooser.words(en, format),
  };
}

const piece = (number: number): Parameters<SymmetryChooser['send']>[0] => ({
  type: 'pick',
  target: {kind: 'piece', piece: number, point: [1, 1]} satisfies Partial<Choice>,
});

it('takes a refusal back with the step after which it was said, and keeps the first choice', () => {
  const {chooser, show, words} = chooserAt();
  chooser.send({type: 'start', tool: 'pair'});
  chooser.send(piece(0));
  chooser.send(piece(0));
  expect(words()).toBe(en.symmetry.refusals.samePiece);
  expect(chooser.marks(sewnSquares() as PatternScene, en, format).message).toBeDefined();
  show({...design});
  expect(words()).toBe(en.symmetry.next.piece);
  expect(chooser.marks(sewnSquares() as PatternScene, en, format).message).toBeUndefined();
});

it('keeps a choice over another step of the same garment', () => {
  const {chooser, show, words} = chooserAt();
  chooser.send({type: 'start', tool: 'pair'});
  chooser.send(piece(0));
  show({...design});
  expect(words()).toBe(en.symmetry.next.piece);
});

it('begins anew with another garment, by the same tool', () => {
  const {chooser, show, words} = chooserAt();
  chooser.send({type: 'start', tool: 'pair'});
  chooser.send(piece(0));
  show({...design, garment: {name: 'b.json', text: '{}'}});
  expect([chooser.tool, words()]).toEqual(['pair', en.symmetry.begin.pair]);
});
