import {describe, expect, it} from 'vitest';

import {formatArea, formatLength, formatPercent, parseLength} from '../../web/src/model/units.js';

/** Locales part numbers from units by spaces of different kinds. */
const plain = (text: string): string => text.replace(/\s/gu, ' ');

describe('a length', () => {
  it('is written in the units and by the rules of whoever reads it', () => {
    expect(formatLength(12.34, 'cm', 'en')).toBe('12.3 cm');
    expect(plain(formatLength(1234.5, 'cm', 'de'))).toBe('1.234,5 cm');
    expect(formatLength(12.7, 'inch', 'en')).toBe('5 in');
  });

  it('is written in millimetres or thousandths of an inch where it is small', () => {
    expect(formatLength(0.127, 'cm', 'en', {fine: true})).toBe('1.3 mm');
    expect(formatLength(0.127, 'inch', 'en', {fine: true})).toBe('0.05 in');
  });

  it('is never minus nought', () => {
    expect(formatLength(-0.01, 'cm', 'en')).toBe('0 cm');
    expect(formatLength(-1, 'cm', 'en')).toBe('-1 cm');
  });
});

it('writes areas with a digit after the point only while they are small', () => {
  expect(plain(formatArea(8.26, 'cm', 'en'))).toBe('8.3 cm²');
  expect(plain(formatArea(1234.56, 'cm', 'en'))).toBe('1,235 cm²');
  expect(plain(formatArea(6.4516, 'inch', 'en'))).toBe('1 in²');
});

it('writes shares in per cent', () => {
  expect(formatPercent(0.125, 'en')).toBe('13%');
  expect(plain(formatPercent(0.125, 'de', 1))).toBe('12,5 %');
});

describe('what somebody types as a length', () => {
  it.each([
    ['12', 12],
    ['12.5', 12.5],
    ['12,5', 12.5],
    [' 4,5 cm ', 4.5],
    ['45mm', 4.5],
    ['1.2 m', 120],
    ['2"', 5.08],
    ['2 in.', 5.08],
    ['1,234.5', 1234.5],
    ['1.234,5', 1234.5],
    ['1 234,5', 1234.5],
    ['.5', 0.5],
    ['-3', -3],
    ['−3', -3],
  ])('"%s" is %d cm', (text, cm) => {
    expect(parseLength(text, 'cm', 'en')).toBeCloseTo(cm, 12);
  });

  it.each([
    ['10', 10],
    ['4 1/2', 4.5],
    ['3/8″', 0.375],
    ['1.5', 1.5],
  ])('"%s" in inches is %d of them', (text, inches) => {
    expect(parseLength(text, 'inch', 'en')).toBeCloseTo(inches * 2.54, 12);
  });

  it.each(['', ' ', 'ten', '4 feet', '1/0', '.', '1.2.3 x', '--4'])('"%s" is none', (text) => {
    expect(parseLength(text, 'cm', 'en')).toBeUndefined();
  });

  it.each(['en', 'de', 'fr', 'ar-EG', 'hi-IN-u-nu-deva'])(
    'is read again as it was written in %s',
    (locale) => {
      const written = new Intl.NumberFormat(locale).format(1234.5);
      expect(parseLength(written, 'cm', locale)).toBeCloseTo(1234.5, 12);
    },
  );
});
