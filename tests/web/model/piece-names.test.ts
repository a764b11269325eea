/** Names of pieces from files with little information. */
import {readdirSync, readFileSync} from 'node:fs';

import {readGarment} from 'seamwise/node';
import {describe, expect, it} from 'vitest';

import {panelMarks} from '@/model/garment/panel-marks.js';
import {documentOf, draftedSquare} from '../../support/garments/documents.js';
import {pieceNames, readable, titleOfFile} from '@/model/garment/piece-names.js';

const named = (labels: Record<string, string | undefined>, chosen = {}): string[] => [
  ...pieceNames(new Map(Object.entries(labels)), chosen).values(),
];

describe('the name of a panel in words', () => {
  it.each([
    ['left_ftorso', 'Left front torso'],
    ['right_btorso', 'Right back torso'],
    ['left_sleeve_f', 'Left sleeve front'],
    ['lfsleeve', 'Left front sleeve'],
    ['Rback', 'Right back'],
    ['Lhood', 'Left hood'],
    ['wb_front', 'Waistband front'],
    ['sl_left_cuff_b', 'Sleeve left cuff back'],
    ['pant_f_l', 'Trouser leg front left'],
    ['skirt_front', 'Skirt front'],
    ['panel-3', 'Panel 3'],
    ['b', 'B'],
    ['collar', 'Collar'],
    ['Vorderteil links', 'Vorderteil links'],
    ['__', '__'],
  ])('of %s is %s', (key, words) => {
    expect(readable(key)).toBe(words);
  });
});

describe('the name of a piece', () => {
  it('is that of its panel where the label is a part of the body', () => {
    expect(named({left_ftorso: 'body', right_ftorso: 'body', skirt: 'leg'})).toEqual([
      'Left front torso',
      'Right front torso',
      'Skirt',
    ]);
  });

  it('is the label where that says more', () => {
    expect(named({p1: 'Centre front', p2: 'Side front'})).toEqual(['Centre front', 'Side front']);
  });

  it('is that of the panel where a label is given twice or is empty', () => {
    expect(named({p_one: 'Front', p_two: 'Front', p_three: ' '})).toEqual([
      'P one',
      'P two',
      'P three',
    ]);
  });

  it('has single letters as sides only where a stem has both, and no other letter', () => {
    const keys = ['Sleeve L', 'Sleeve R', 'Panel A', 'Panel B', 'Panel F', 'Gore 1 B'];
    expect(named(Object.fromEntries(keys.map((key) => [key, undefined])))).toEqual([
      ...['Sleeve left', 'Sleeve right', 'Panel A', 'Panel B', 'Panel F', 'Gore 1 B'],
    ]);
  });

  it('stays as in the file where words would be the same for two', () => {
    expect(named({front_l: undefined, front_r: undefined, front_left: undefined})).toEqual([
      'front_l',
      'Front right',
      'front_left',
    ]);
  });

  it('is the chosen one before all others', () => {
    expect(named({front: 'Front', back: undefined}, {front: 'Bib', constructor: 'x'})).toEqual([
      'Bib',
      'Back',
    ]);
  });

  it('may be chosen in a garment file, and in the design over it', () => {
    const garment = documentOf([draftedSquare('front'), draftedSquare('back')], {
      names: {front: 'Bib', back: 'Rear'},
    });
    const marks = panelMarks(garment, {names: {back: 'Seat'}});
    expect([...marks.values()].map(({label}) => label)).toEqual(['Bib', 'Seat']);
  });

  it('is never given twice in the sample garments', async () => {
    for (const name of readdirSync('public/garments')) {
      const text = readFileSync(`public/garments/${name}`, 'utf8');
      const labels = [...panelMarks(await readGarment(text)).values()].map((one) => one.label);
      expect(new Set(labels).size, name).toBe(labels.length);
    }
  });
});

it.each([
  ['shirt_mean_specification.json', 'Shirt mean'],
  ['tee-m.json', 'Tee m'],
  ['../garments/my jacket.seamwise.json', 'My jacket'],
  ['.json', 'Json'],
])('the title of %s is %s', (file, title) => {
  expect(titleOfFile(file)).toBe(title);
});
