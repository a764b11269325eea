/** Lengths, areas and shares as people read and write them. */

export type Units = 'cm' | 'inch';

const cmPerInch = 2.54;

const formats = new Map<string, Intl.NumberFormat>();

/** Making one takes far longer than using it. */
function numberFormat(locale: string, options: Intl.NumberFormatOptions): Intl.NumberFormat {
  const key = locale + JSON.stringify(options);
  const known = formats.get(key) ?? new Intl.NumberFormat(locale, options);
  formats.set(key, known);
  return known;
}

/** Zero is never negative. */
const formatted = (locale: string, value: number, options: Intl.NumberFormatOptions): string =>
  numberFormat(locale, {signDisplay: 'negative', ...options}).format(value);

export interface LengthStyle {
  /** For what is small: millimetres, or inches to the thousandth. */
  readonly fine?: boolean;
}

/** "12.3 cm", "4.84 in"; fine: "1.3 mm", "0.051 in". */
export function formatLength(
  cm: number,
  units: Units,
  locale: string,
  {fine = false}: LengthStyle = {},
): string {
  if (units === 'inch') {
    return formatted(locale, cm / cmPerInch, {
      ...{style: 'unit', unit: 'inch', maximumFractionDigits: fine ? 3 : 2},
    });
  }
  const [value, unit] = fine ? [10 * cm, 'millimeter'] : [cm, 'centimeter'];
  return formatted(locale, value, {style: 'unit', unit, maximumFractionDigits: 1});
}

/** "8.3 cm²", "214 in²": one digit after the point while there is one before it. */
export function formatArea(cm2: number, units: Units, locale: string): string {
  const [value, unit] = units === 'inch' ? [cm2 / cmPerInch ** 2, 'in²'] : [cm2, 'cm²'];
  const maximumFractionDigits = Math.abs(value) < 10 ? 1 : 0;
  return `${formatted(locale, value, {maximumFractionDigits})}\u00a0${unit}`;
}

/** "12.5 %" of a share of 0.125, as the locale writes it. */
export const formatPercent = (share: number, locale: string, digits = 0): string =>
  formatted(locale, share, {style: 'percent', maximumFractionDigits: digits});

const inCm: Readonly<Record<string, number>> = {
  ...{mm: 0.1, cm: 1, m: 100},
  ...{in: cmPerInch, inch: cmPerInch, inches: cmPerInch, '"': cmPerInch, '″': cmPerInch},
};

/** The digits of a locale as those of ASCII. */
function plainDigits(text: string, locale: string): string {
  const digits = Array.from(formatted(locale, 9876543210, {useGrouping: false})).reverse();
  return text.replace(/\p{Nd}/gu, (digit) => {
    const value = digits.indexOf(digit);
    return value < 0 ? digit : String(value);
  });
}

/** "1234.5" of "1,234.5", "1.234,5" and "1 234,5": the last point or comma is the decimal one. */
function decimal(text: string): number {
  const [whole = '', fraction = ''] = text
    .replace(/[\s'’٬](?=\d)/gu, '')
    .replace('٫', '.')
    .split(/[.,](?=[^.,]*$)/);
  return Number(`${whole.replace(/[.,]/g, '')}.${fraction}`);
}

/**
 * What somebody typed as a length, in cm; undefined when it is none. Without a unit of its own it is in
 * `units`. Decimal points and commas, and fractions of inches: "12,5", "4.5 cm", "4 1/2", "3/8″".
 */
export function parseLength(text: string, units: Units, locale: string): number | undefined {
  const plain = plainDigits(text.trim().toLowerCase(), locale).replace('−', '-');
  const match =
    /^([-+]?)\s*([\d.,\s'’٬٫]*?)\s*(?:(\d+)\s*[/⁄]\s*(\d+))?\s*(\p{L}+\.?|["″])?$/u.exec(plain);
  if (!match) return undefined;
  const [, sign, number = '', over, under, unit] = match;
  if (!/\d/.test(number) && over === undefined) return undefined;
  const factor = unit === undefined ? inCm[units] : inCm[unit.replace('.', '')];
  const fraction = over === undefined ? 0 : Number(over) / Number(under);
  const value = (decimal(number === '' ? '0' : number) + fraction) * (factor ?? NaN);
  if (!Number.isFinite(value)) return undefined;
  return sign === '-' ? -value : value;
}
