/** Lengths as people read them. */

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
