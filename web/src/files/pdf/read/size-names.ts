/** Names of sizes in names of layers and in legends. */

const size = '(?:[2-6]?X{0,4}[SL]|M|[2-6]X|\\d{1,3}(?:\\s?[-/]\\s?\\d{1,3})?)';
const word =
  '(?:size|sizes|gr(?:ö|oe|o)?(?:ß|ss)?e?n?\\.?|taille|tailles|taglia|talla|eu|eur|de|fr|it|us|uk|t\\.?)';

const whole = new RegExp(`^(?:${word})?[\\s_:.-]*(${size})(?:[\\s_:.-]+.*)?$`, 'i');
const within = new RegExp(`(?:^|[^\\p{L}\\d])${word}[\\s_:.-]*(${size})(?![\\p{L}\\d])`, 'iu');

const noSize = /^(?:layer|ebene|calque|livello|capa|page|seite)\b/i;

/** The size that a name states; undefined for other names. */
export function sizeIn(name: string): string | undefined {
  const trimmed = name.trim();
  const found = within.exec(trimmed) ?? (noSize.test(trimmed) ? null : whole.exec(trimmed));
  return found?.[1]?.replaceAll(/\s/g, '').toUpperCase();
}

const letters = ['XXXXS', 'XXXS', 'XXS', 'XS', 'S', 'M', 'L', 'XL', 'XXL', 'XXXL', 'XXXXL'];

/** The order of a size: by number, or by letters. */
export function rankOf(name: string): number {
  const spelled = name.replace(
    /^([2-6])X([SL])?$/,
    (_, count: string, end = 'L') => 'X'.repeat(Number(count)) + String(end),
  );
  const place = letters.indexOf(spelled);
  return place >= 0 ? place : (Number.parseInt(name, 10) || 0) + 100;
}
