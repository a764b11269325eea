import {describe, expect, it} from 'vitest';

import {formatLength, fractionOrNumber, numberTyped} from '@/model/base/length-text.js';

/** Locales separate numbers and units by different kinds of spaces. */
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

  it('is written in sixteenths of an inch, as rulers have them', () => {
    const inches = (value: number, locale = 'en'): string =>
      plain(formatLength(2.54 * value, 'inch', locale));
    expect(inches(0.375)).toBe('3/8 in');
    expect(inches(1.5)).toBe('1 1/2 in');
    expect(inches(16.14)).toBe('16 1/8 in');
    expect(inches(0.99)).toBe('1 in');
    expect(inches(-0.375)).toBe('-3/8 in');
    expect(inches(0.01)).toBe('0 in');
    expect(inches(1200.25)).toBe('1,200 1/4 in');
    expect(inches(0.625, 'de')).toBe('5/8 in');
    expect(inches(20.0625, 'fr')).toBe('20 1/16 po');
  });

  it('is never minus nought', () => {
    expect(formatLength(-0.01, 'cm', 'en')).toBe('0 cm');
    expect(formatLength(-1, 'cm', 'en')).toBe('-1 cm');
  });
});

describe('a number that is typed', () => {
  it.each([
    ['0.375', 0.375],
    ['0,375', 0.375],
    ['3/8', 0.375],
    [' 1 1/2 ', 1.5],
    ['1-1/2', 1.5],
    ['12', 12],
    ['-4', -4],
  ])('may be %s', (text, number) => {
    expect(numberTyped(text)).toBe(number);
  });

  it.each(['', ' ', 'wide', '1/2/3', '3/', '1 1', '3/8 in'])("may not be '%s'", (text) => {
    expect(numberTyped(text)).toBeNaN();
  });

  it('is shown as a fraction where it is one', () => {
    expect(fractionOrNumber(0.375, 2)).toBe('3/8');
    expect(fractionOrNumber(1.5, 2)).toBe('1 1/2');
    expect(fractionOrNumber(4, 2)).toBe('4');
    expect(fractionOrNumber(0, 2)).toBe('0');
    expect(fractionOrNumber(1 / 2.54, 3)).toBe('0.394');
    expect(fractionOrNumber(3.937, 2)).toBe('3.94');
  });
});
