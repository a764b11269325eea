/** Lengths as text for people. */

export type Units = 'cm' | 'inch';

const cmPerInch = 2.54;

const formats = new Map<string, Intl.NumberFormat>();

/** Formats are cached, because making one takes far longer than using it. */
function numberFormat(locale: string, options: Intl.NumberFormatOptions): Intl.NumberFormat {
  const key = locale + JSON.stringify(options);
  const known = formats.get(key) ?? new Intl.NumberFormat(locale, options);
  formats.set(key, known);
  return known;
}

/** Formats a number; zero is never negative. */
const formatted = (locale: string, value: number, options: Intl.NumberFormatOptions): string =>
  numberFormat(locale, {signDisplay: 'negative', ...options}).format(value);

interface LengthStyle {
  /** Format for small lengths: millimetres, or inches to the thousandth. */
  readonly fine?: boolean;
}

/** Inches as on rulers and patterns, to the sixteenth: "4 7/8 in". */
function inFractions(inches: number, locale: string): string {
  const sixteenths = Math.round(16 * Math.abs(inches));
  const whole = Math.floor(sixteenths / 16);
  const text = formatted(locale, whole, {style: 'unit', unit: 'inch'});
  const number = formatted(locale, whole, {});
  const sign = inches < 0 && sixteenths > 0 ? '-' : '';
  return sign + text.replace(number, () => mixed(number, sixteenths % 16));
}

/** A whole number followed by sixteenths. */
function mixed(whole: string, sixteenths: number): string {
  if (sixteenths === 0) return whole;
  const shared = sixteenths & -sixteenths; // the greatest power of two that divides both
  const fraction = `${sixteenths / shared}/${16 / shared}`;
  return whole === '0' ? fraction : `${whole}\u00a0${fraction}`;
}

/**
 * Inches in an input field: a fraction such as "1 1/2" where they are one, otherwise a number such
 * as "0.394".
 */
export function fractionOrNumber(inches: number, digits: number): string {
  const sixteenths = Math.round(16 * inches);
  if (inches < 0 || Math.abs(sixteenths / 16 - inches) > 1e-4) {
    return String(Number(inches.toFixed(digits)) + 0);
  }
  return mixed(String(Math.floor(sixteenths / 16)), sixteenths % 16).replace('\u00a0', ' ');
}

/** Parses "0.375", "0,375", "3/8", "1 1/2" and "1-1/2"; NaN for any other text. */
export function numberTyped(text: string): number {
  const plain = text.trim().replace(',', '.');
  const [, whole, top, bottom] = /^(?:(\d+)[\s-]+)?(\d+)\s*[/⁄]\s*(\d+)$/u.exec(plain) ?? [];
  if (top !== undefined) return Number(whole ?? 0) + Number(top) / Number(bottom);
  return plain === '' ? NaN : Number(plain);
}

/** Formats a length: "12.3 cm", "4 7/8 in"; fine: "1.3 mm", "0.051 in". */
export function formatLength(
  cm: number,
  units: Units,
  locale: string,
  {fine = false}: LengthStyle = {},
): string {
  if (units === 'inch') {
    const inches = cm / cmPerInch;
    if (!fine) return inFractions(inches, locale);
    return formatted(locale, inches, {style: 'unit', unit: 'inch', maximumFractionDigits: 3});
  }
  const [value, unit] = fine ? [10 * cm, 'millimeter'] : [cm, 'centimeter'];
  return formatted(locale, value, {style: 'unit', unit, maximumFractionDigits: 1});
}
