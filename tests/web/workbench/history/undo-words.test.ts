/** The descriptions of undo, for every kind of step. */
import {expect, it} from 'vitest';

import {changeBetween, redoWords, undoWords, type Change} from '@/workbench/history/step-change.js';
import {withSolveSettings, withPreset, solveSettingsOf} from '@/workbench/presets.js';
import {
  withGrain,
  withGrainLines,
  withImportance,
  withName,
  withoutPin,
  withPrinted,
  withQuarterTurn,
} from '@/workbench/lists/changed-options.js';
import {en} from '@/texts/en.js';
import {samplePrint, type SamplePrint} from '@/workbench/samples.js';
import type {Workbench} from '@/workbench/workbench.js';
import {askedSymmetries, type Design} from '@/model/design/design.js';

const ogee: SamplePrint = {
  ...{name: 'cm', title: 'Ogee tulip', group: 'cm', w1: [12, 0], w2: [6, 9]},
  colourways: [
    {name: 'day', image: 'cm.svg'},
    {name: 'night', image: 'cm-night.svg'},
  ],
};

const design: Design = {
  garment: {name: 'apron-m.json', text: '{}', sample: {style: 'apron', size: 'm'}},
  print: samplePrint(ogee),
  symmetry: [{kind: 'piece', piece: 'bib'}],
  seed: 1,
  method: 'best',
  options: {maxChangeCm: 1, grain: {default: 'on'}, pins: {bib: at(1)}},
};

function at(x: number) {
  return {angle: 0, translation: [x, 0] as const};
}

const {options, print, garment} = design;
const cases: readonly (readonly [step: string, change: Partial<Design>, said: Change])[] = [
  ['another garment', {garment: {name: 'tee.json', text: '[]'}}, {kind: 'garment'}],
  [
    'another size',
    {garment: {...garment, name: 'apron-l.json', sample: {style: 'apron', size: 'l'}}},
    {kind: 'size'},
  ],
  ['another unit', {garment: {name: garment.name, text: '{"units": 1}'}}, {kind: 'unit'}],
  ['another print', {print: {...print, title: 'Dots', group: 'p4m'}}, {kind: 'print'}],
  ['other colours', {print: samplePrint(ogee, 'night')}, {kind: 'colours'}],
  [
    'another size of the print',
    {print: {...print, size: {...print.size, width: 3}}},
    {kind: 'printSize'},
  ],
  ['a turn of the print', {print: {...print, turnDeg: 30}}, {kind: 'turn'}],
  ['a print that has an upside', {print: {...print, oneWay: true}}, {kind: 'print'}],
  [
    'a symmetry more',
    {symmetry: [...askedSymmetries(design), {kind: 'pair', pieces: ['tie', 'tie 2']}]},
    {kind: 'symmetry', pieces: ['tie', 'tie 2']},
  ],
  ['a symmetry less', {symmetry: 'none'}, {kind: 'symmetry', pieces: ['bib']}],
  ['another name', {names: withName(undefined, 'bib', 'Top')}, {kind: 'name', pieces: ['bib']}],
  [
    'a quarter turn',
    {options: withQuarterTurn(options, 'waistband')},
    {kind: 'turned', pieces: ['waistband']},
  ],
  [
    'a quarter turn with the pin that moves with it',
    {options: {...withQuarterTurn(options, 'bib'), pins: {bib: at(2)}}},
    {kind: 'turned', pieces: ['bib']},
  ],
  [
    'another grain of a piece',
    {options: withGrain(options, 'bib', 'bias')},
    {kind: 'grain', pieces: ['bib']},
  ],
  [
    'grain lines',
    {options: withGrainLines(options, {bib: 90, tie: 0})},
    {kind: 'grain', pieces: ['bib', 'tie']},
  ],
  [
    'the grain of all',
    withSolveSettings(design, {...solveSettingsOf(design), grain: 'free'}),
    {kind: 'grain'},
  ],
  [
    'the greatest change',
    withSolveSettings(design, {...solveSettingsOf(design), maxChangeCm: 0.5}),
    {kind: 'change'},
  ],
  ['placing only', withPreset(design, 'placeOnly'), {kind: 'change'}],
  [
    'a print that only continues',
    withSolveSettings(design, {...solveSettingsOf(design), continuousOnly: true}),
    {kind: 'cutting'},
  ],
  [
    'another method',
    withSolveSettings(design, {...solveSettingsOf(design), method: 'paper'}),
    {kind: 'method'},
  ],
  [
    'several of these at once',
    {...withSolveSettings(design, {...solveSettingsOf(design), grain: 'free', maxChangeCm: 0.4})},
    {kind: 'cutting'},
  ],
  ['a kept edge', {options: {...options, locked: {bib: [2]}}}, {kind: 'keep', pieces: ['bib']}],
  ['open edges that may move', {options: {...options, openEdges: 'free'}}, {kind: 'openEdges'}],
  [
    'the weight of a seam',
    {options: withImportance(options, [3], 'first')},
    {kind: 'matching', seams: [3]},
  ],
  [
    'a seam that need not match',
    {options: withImportance({...options, weights: {}, unmatched: []}, [3], 'none')},
    {kind: 'matching', seams: [3]},
  ],
  [
    'a plain piece',
    {options: withPrinted(options, 'bib', false)},
    {kind: 'printed', pieces: ['bib']},
  ],
  [
    'a moved print',
    {options: {...options, pins: {bib: at(1), tie: at(5)}}},
    {kind: 'place', pieces: ['tie']},
  ],
  ['a freed piece', {options: withoutPin(options, 'bib')}, {kind: 'place', pieces: ['bib']}],
  ['a better match', {seed: 3}, {kind: 'better'}],
];

it.each(cases)('names %s', (_, change, said) => {
  expect(changeBetween(design, {...design, ...change})).toEqual(said);
});

it('names another step than the effort where both end', () => {
  const improved = {...design, options: {...options, effort: 4}};
  const kept = {...design, options: {...options, locked: {bib: true}} as Design['options']};
  expect(changeBetween(improved, kept)).toEqual({kind: 'keep', pieces: ['bib']});
});

/** A workbench whose history has one step back and one forward. */
const deskOf = (past: Design, present: Design, future: Design): Workbench =>
  ({
    history: {
      steps: {
        past: [{design: past, view: null}],
        present: {design: present, view: null},
        future: [{design: future, view: null}],
      },
    },
    sheet: {scenes: {now: {pieces: [{name: 'waistband', label: 'Waistband'}]}}},
  }) as unknown as Workbench;

it('says of which piece, by the name that it is called by', () => {
  const turned = {...design, options: withQuarterTurn(options, 'waistband')};
  const named = {...turned, names: {waistband: 'Belt'}};
  const workbench = deskOf(design, turned, named);
  expect(undoWords(workbench, en)).toBe('turn Waistband');
  expect(redoWords(workbench, en)).toBe('name, Belt');
});

it('says which size and which print', () => {
  const sized = {
    ...design,
    garment: {...garment, text: '[]', sample: {style: 'apron', size: 'xl'}},
  };
  const dotted = {...sized, print: {...print, title: 'Dots', group: 'p4m' as const}};
  const workbench = deskOf(design, sized, dotted);
  expect([undoWords(workbench, en), redoWords(workbench, en)]).toEqual(['size, XL', 'print, Dots']);
});
