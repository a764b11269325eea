import {describe, expect, it} from 'vitest';

import {choiceOf, choices, groupOf, meaningOf} from '@/print/group-choice.js';
import {lostSymmetries} from '@/workbench/print/take-print.js';
import {turnsOver} from '@/model/print/repeat.js';
import {noPicture, type Design} from '@/model/design/design.js';
import {printFrom} from '@/print/read-print.js';
import {solveSettingsOf, presetOf, withSolveSettings, withPreset} from '@/workbench/presets.js';
import {storedPreferences} from '@/app/storage/preferences.js';
import {en} from '@/texts/en.js';
import {groupNames} from '@/model/base/core-tables.js';
import type {Symmetry} from '@/model/garment/symmetries.js';

const front: Symmetry = {kind: 'piece', piece: 'front'};
const sleeves: Symmetry = {kind: 'pair', pieces: ['left', 'right']};
const square = {width: 8, height: 8, angleDeg: 90};

describe('the gallery', () => {
  it('offers every group, and stripes as pmm', () => {
    expect(choices.map(groupOf)).toEqual([...groupNames, 'pmm']);
  });

  it('says of asymmetric stripes that they do not mirror', () => {
    const size = {...square, height: 0.5};
    expect(meaningOf({group: 'pm', size})).toBe('stripesOneWay');
    expect(meaningOf({group: 'pmm', size})).toBe('stripes');
    expect(meaningOf({group: 'pm', size: square})).toBe('pm');
  });

  it('calls a print stripes when its mirrors run across a repeat of half a centimetre', () => {
    expect(choiceOf({group: 'pmm', size: {...square, height: 0.5}})).toBe('stripes');
    expect(choiceOf({group: 'pm', size: {...square, height: 0.5}})).toBe('stripes');
    expect(choiceOf({group: 'pgg', size: {...square, height: 0.5}})).toBe('pgg');
    expect(choiceOf({group: 'pmm', size: square})).toBe('pmm');
  });

  it('keeps pieces symmetric on mirrors, and pairs on mirrors or glides', () => {
    expect(lostSymmetries('pg', {symmetry: [front, sleeves]})).toEqual([front]);
    expect(lostSymmetries('p4', {symmetry: [front, sleeves]})).toEqual([front, sleeves]);
    expect(lostSymmetries('cm', {symmetry: [front, sleeves]})).toEqual([]);
    expect(lostSymmetries('p1', {symmetry: 'none'})).toEqual([]);
  });

  it('knows the groups that look the same upside down', () => {
    const without = groupNames.filter((group) => !turnsOver(group));
    expect(without).toEqual(['p1', 'pm', 'pg', 'cm', 'p3', 'p3m1', 'p31m']);
  });

  it('says of every choice what it means', () => {
    expect(Object.keys(en.print.meanings)).toEqual([...choices, 'stripesOneWay']);
  });
});

describe('a print file', () => {
  const words = en.print.files;
  const file = {group: 'pmm', w1: [0, 9], w2: [-7, 0], image: 'own.svg', title: 'Own'};
  const read = (change: object) => printFrom(JSON.stringify({...file, ...change}), 'a.json', words);

  it('is read as a maker measures it, and waits for its picture', () => {
    const print = read({});
    expect(print).toMatchObject({title: 'Own', group: 'pmm', oneWay: false, cell: 'primitive'});
    expect(print.size.width).toBeCloseTo(9, 12);
    expect(print.size.height).toBeCloseTo(7, 12);
    expect(print.turnDeg).toBeCloseTo(90, 12);
    expect(print.image).toBe(noPicture);
  });

  it('may bring its picture along', () => {
    expect(read({image: 'data:image/png;base64,AA'}).image).toBe('data:image/png;base64,AA');
  });

  it('is called like the file where it has no title', () => {
    expect(read({title: undefined}).title).toBe('a');
  });

  it.each([{group: 'p5'}, {w1: [1]}, {w2: ['0', '1']}, {w1: undefined}])(
    'is none with %o',
    (change) => {
      expect(() => read(change)).toThrow(words.noPrint('a.json'));
    },
  );

  it('is none when it is no JSON at all', () => {
    expect(() => printFrom('<svg/>', 'a.json', words)).toThrow(words.noPrint('a.json'));
  });

  it.each([{w2: [-7, 1]}, {w2: [7, 0]}, {w1: [0, 0]}, {group: 'p4m'}, {group: 'p1', w2: [7, 0]}])(
    'has to span a lattice of its group, which it does not with %o',
    (change) => {
      expect(() => read(change)).toThrow(/does not fit its symmetry/);
    },
  );
});

describe('the starting points', () => {
  const design: Design = {
    garment: {name: 'g.json', text: '{}'},
    print: {
      ...{title: '', group: 'p1', size: square, turnDeg: 0, oneWay: false},
      ...{cell: 'primitive', image: ''},
    },
    symmetry: 'none',
    seed: 1,
    method: 'best',
    options: {maxChangeCm: 1, grain: {default: 'on', pieces: {cuff: 'bias'}}, weights: {2: 3}},
  };

  it('are recognised by what they decide', () => {
    expect(presetOf(design)).toBe('homeSewist');
    expect(presetOf({...design, method: 'paper'})).toBeUndefined();
    expect(presetOf({...design, ...withPreset(design, 'wovenShirt')})).toBe('wovenShirt');
  });

  it('leave alone what was decided about single pieces and seams', () => {
    const {options} = withPreset(design, 'bestFit');
    expect(options.grain).toEqual({default: 'free', pieces: {cuff: 'bias'}});
    expect(options.weights).toEqual({2: 3});
  });

  it('count an option that is left out as its default', () => {
    const plain = {...design, options: {}};
    expect(presetOf(plain)).toBe('bestFit');
    const bias = {
      ...plain,
      ...withSolveSettings(plain, {...solveSettingsOf(plain), grain: 'bias'}),
    };
    expect(solveSettingsOf(bias)).toMatchObject({grain: 'bias', maxChangeCm: 1});
  });
});

it('prefers what the browser says where nothing can be stored', () => {
  expect(storedPreferences('de-AT')).toMatchObject({language: 'de', units: 'cm'});
});
