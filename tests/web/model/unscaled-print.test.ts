/**
 * Prints of unknown size: they stay unscaled throughout a design's use, are never cut, and any
 * entered size scales them.
 */
import {expect, it} from 'vitest';

import {cutSheet} from '@/cutting/lay-sheet.js';
import {markerOrder} from '@/marker/problem.js';
import {printOf, type DesignPrint} from '@/model/design/design.js';
import {printMeasures} from '@/model/design/read-design.js';
import {readPrintFile} from '@/model/print/read-print-file.js';
import {checkScaled} from '@/model/result/unscaled-print.js';
import {printOfStored} from '@/model/documents/filed-design.js';
import {pictureIn, resized} from '@/model/design/tile-repeat.js';

const print: DesignPrint = {
  ...{title: 'meadow', group: 'pmm', turnDeg: 0, oneWay: false, cell: 'primitive'},
  ...{size: {width: 10, height: 8, angleDeg: 90}, image: 'data:image/png;base64,', unscaled: true},
};

const refusal = /^The size of the print 'meadow' is unknown.*measure a repeat/;

it('is refused before anything is cut or laid', () => {
  expect(() => {
    checkScaled(printOf(print));
  }).toThrow(refusal);
  const result = {} as Parameters<typeof cutSheet>[0];
  expect(() =>
    cutSheet(result, printOf(print), {panels: new Map()}, {allowanceCm: 1, units: 'cm'}),
  ).toThrow(refusal);
  expect(() => markerOrder([], {widthCm: 140}, print)).toThrow(refusal);
});

it('is measured by any size that is entered', () => {
  const measured = resized(print, {width: 12, height: 9.6, angleDeg: 90});
  expect(printOf(measured)).not.toHaveProperty('unscaled');
  expect(pictureIn(print).unscaled).toBe(true);
  expect(pictureIn(measured).unscaled).toBeUndefined();
});

it('stays so in projects, links and files, until a design gives it a size', () => {
  expect(printMeasures(JSON.parse(JSON.stringify(print)), '').unscaled).toBe(true);
  const file = JSON.stringify({group: 'pmm', w1: [10, 0], w2: [0, 8], unscaled: true});
  expect(readPrintFile(file, 'meadow.json').unscaled).toBe(true);
  const place = {url: 'meadow.json', sha256: ''};
  expect(printOfStored({print: place}, file).unscaled).toBe(true);
  expect(printOfStored({print: {...place, size: print.size}}, file).unscaled).toBe(false);
});
