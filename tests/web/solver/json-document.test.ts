import fc from 'fast-check';
import {expect, it} from 'vitest';

import {documentBytes, documentValue} from '@/solver/json/document.js';

const limits = {maxFileBytes: 1e6, maxValues: 1e6};
const there = (text: string): Uint8Array => documentBytes(text, limits);
const andBack = (text: string): unknown => documentValue(there(text) as Uint8Array<ArrayBuffer>);

/** The document's head in memory: number of nodes, error, line and column. */
const headOf = (bytes: Uint8Array): number[] => [...new Uint32Array(bytes.buffer, 0, 4)];

it('brings every value to the module and back', () => {
  fc.assert(
    fc.property(fc.jsonValue({maxDepth: 6}), fc.constantFrom(0, 1, '\t'), (value, indent) => {
      expect(andBack(JSON.stringify(value, null, indent))).toEqual(
        JSON.parse(JSON.stringify(value)),
      );
    }),
  );
});

it('brings more than there is room for at first', () => {
  const value = Array.from({length: 5000}, (_, k) => ({[`name ${k}`]: [k / 3, `text ${k}é`]}));
  expect(andBack(JSON.stringify(value))).toEqual(value);
});

it('keeps members in the order of the text, and both of one name', () => {
  const bytes = there('{"b": 1, "10": 2, "b": 3}');
  expect(headOf(bytes)).toEqual([7, 0, 0, 0]);
  expect(new TextDecoder().decode(bytes.subarray(8 * 16))).toBe('b10');
});

it('keeps a member whose name means something to the engine', () => {
  const back = andBack('{"__proto__": {"a": 1}}') as object;
  expect(Object.keys(back)).toEqual(['__proto__']);
  expect(Object.getPrototypeOf(back)).toBe(Object.prototype);
});

it('reads numbers as numbers are read', () => {
  const tokens = ['0', '1e5', '-1.25E-3', '0.30000000000000004', '12345678901234567890', '1e-400'];
  expect(andBack(`[${tokens.join()}]`)).toEqual(tokens.map(Number));
  expect(andBack('[-0, -0.0]')).toEqual([0, -0]); // integers have no -0
});

it('leaves out a mark at the beginning, and no other', () => {
  expect(andBack('\ufeff["\ufeffa"]')).toEqual(['\ufeffa']);
});

it('ends where the text breaks or has too many values', () => {
  expect(headOf(there('[1,\n oops]'))).toEqual([2, 4, 2, 2]);
  expect(headOf(documentBytes('[1, 2, 3, oops]', {...limits, maxValues: 3}))).toEqual([4, 0, 0, 0]);
});
