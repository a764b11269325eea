import {describe, expect, it} from 'vitest';

import {formatLength} from '../../web/src/model/units.js';

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
