/** The parts of a customer's design that survive a change of the page's request. */
import {expect, it} from 'vitest';

import {nextDesign, type Answered} from '@/element/garment/designs.js';
import type {Asked} from '@/element/garment/sources.js';
import type {Design} from '@/model/design/design.js';
import type {GarmentDocument} from '@/model/garment/garment-document.js';
import {bareFabric} from '@/workbench/samples.js';
import {documentOf, draftedSquare} from '../../support/garments/documents.js';

const pins = {
  front: {angle: 0.1, translation: [3, 4]},
  sleeve: {angle: 0, translation: [1, 2]},
} as const;

interface Read extends Answered {
  readonly read: GarmentDocument;
}

/** A garment as read for a request. */
function answered(garment: string, read: GarmentDocument, change: Partial<Asked> = {}): Read {
  return {
    read,
    asked: {
      ...{garment, size: 'm', print: 'p.json', colourway: undefined, symmetry: 'auto'},
      ...{maxChangeCm: 1, fabric: 'poplin', ...change},
    },
    loaded: {
      garment: {name: 'garment.json', text: ''},
      ...{print: bareFabric, symmetry: 'auto'},
    },
  };
}

const pieces = (...names: string[]): GarmentDocument =>
  documentOf(names.map((name) => draftedSquare(name, {label: 'front'})));

/** The design of one garment, with the print placed by the customer. */
function placedOn(before: Answered): Design {
  const design = nextDesign(before, undefined, undefined);
  return {...design, options: {...design.options, pins}};
}

function keptPins(before: Read, after: Read): string[] {
  const read = {before: before.read, next: after.read};
  return Object.keys(nextDesign(after, before, placedOn(before), read).options.pins ?? {});
}

it('keeps where a print was put on another size of the same template, on the pieces that it has', () => {
  const before = answered('tee-{size}.json', pieces('front', 'sleeve'));
  const after = answered('tee-{size}.json', pieces('front', 'back'), {size: 'l'});
  expect(keptPins(before, after)).toEqual(['front']);
});

it('keeps it on another file that bears the same title', () => {
  const before = answered('tee-m.json', {title: 'Tee', ...pieces('front', 'sleeve')});
  const after = answered('tee-l.json', {title: 'Tee', ...pieces('front', 'sleeve')});
  expect(keptPins(before, after)).toEqual(['front', 'sleeve']);
});

it('puts no print on another garment that has a piece of the same name', () => {
  const before = answered('tee-m.json', {title: 'Tee', ...pieces('front', 'sleeve')});
  for (const after of [
    answered('dress-m.json', {title: 'Dress', ...pieces('front', 'sleeve')}),
    answered('dress-m.json', pieces('front', 'sleeve')),
  ]) {
    expect(keptPins(before, after)).toEqual([]);
  }
  const untitled = answered('tee-m.json', pieces('front'));
  expect(keptPins(untitled, answered('dress-m.json', pieces('front')))).toEqual([]);
});

it('keeps it while only the print or the greatest change is another', () => {
  const before = answered('tee-m.json', pieces('front', 'sleeve'));
  const {asked, loaded, read} = before;
  const after = {read, asked: {...asked, maxChangeCm: 0.5, print: 'q.json'}, loaded: {...loaded}};
  expect(keptPins(before, after)).toEqual(['front', 'sleeve']);
});

it('keeps the symmetries that a customer has let go of, and what pieces are called, on the same garment', () => {
  const before = answered('tee-m.json', pieces('front'));
  const now: Design = {...placedOn(before), symmetry: 'none', seed: 3, names: {front: 'Vorn'}};
  const after = {...before, asked: {...before.asked, print: 'q.json'}};
  const kept = {symmetry: 'none', seed: 3, names: {front: 'Vorn'}};
  expect(nextDesign(after, before, now)).toMatchObject(kept);
  const other = nextDesign(answered('dress-m.json', pieces('front')), before, now);
  expect(other).toMatchObject({symmetry: 'auto', seed: 3});
  expect(other).not.toHaveProperty('names');
});

it('is of the fabric that was asked for last, by the page or by the customer', () => {
  const first = answered('tee-m.json', pieces('front'), {fabric: 'denim'});
  const design = nextDesign(first, undefined, undefined);
  expect(design.fabric).toBe('denim');
  const next = answered('dress-m.json', pieces('front'), {fabric: 'denim'});
  expect(nextDesign(next, first, {...design, fabric: 'jersey'}).fabric).toBe('jersey');
  const usual = answered('dress-m.json', pieces('front'));
  expect(nextDesign(usual, first, {...design, fabric: 'jersey'}).fabric).toBeUndefined();
});
