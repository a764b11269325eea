import {describe, expect, it} from 'vitest';

import {collection} from '@samples/prints/collection.js';
import {even, plaidCell, sett, stripeCell} from '@samples/prints/plaid.js';

const symmetric = even('ground 1 line 2 leaf 1');
const other = even('ground 2 line 2 bloom 1');
const uneven = sett('ground 1 line 2 leaf 3');
const unevenToo = sett('ground 2 line 1 leaf 3');

it('reads a half sett to its end and back, with the bands at both ends whole', () => {
  expect(even('ground 1 line 2 leaf 1')).toEqual(
    sett('ground 0.5 line 2 leaf 0.5 leaf 0.5 line 2 ground 0.5'),
  );
});

it('refuses a colour that no colourway has', () => {
  expect(() => sett('ground 1 mauve 2')).toThrow('mauve');
});

describe('the group of a plaid', () => {
  it.each([
    ['even in both, the same', symmetric, symmetric, 'p4m'],
    ['even in both', symmetric, other, 'pmm'],
    ['uneven in the weft', symmetric, uneven, 'pm'],
    ['uneven in the warp', uneven, symmetric, 'pm'],
    ['uneven in both, the same', uneven, uneven, 'cm'],
    ['uneven in both', uneven, unevenToo, 'p1'],
  ] as const)('%s', (_, warp, weft, group) => {
    expect(plaidCell(warp, weft).group).toBe(group);
  });

  it('has its mirrors along the warp when only the weft is uneven, across it when only the warp is', () => {
    expect(plaidCell(symmetric, uneven).w1[0]).toBeCloseTo(0, 12);
    expect(plaidCell(uneven, symmetric).w1[1]).toBeCloseTo(0, 12);
  });
});

it('takes a stripe for pmm when it reads the same both ways, else for pm with mirrors across it', () => {
  expect(stripeCell(symmetric).group).toBe('pmm');
  expect(stripeCell(uneven)).toMatchObject({group: 'pm', w1: [6, 0]});
});

it('has two even plaids and an uneven one, an even stripe and an uneven one', () => {
  const group = (name: string) => collection.find(({id}) => id === name)?.cell.group;
  expect(['tartan', 'check', 'plaid', 'ticking', 'regatta'].map(group)).toEqual([
    'p4m',
    'pmm',
    'p1',
    'pmm',
    'pm',
  ]);
});
