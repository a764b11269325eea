/** Reads in five languages whether the lines of a pattern include the seam allowance. */

const words =
  'seam allowances?|nahtzugaben?|nahtzuschlag|marges? de couture|valeurs? de couture|margin[ei] di cucitura|m[aá]rgen(?:es)? de costura';
const included = 'includ|enthalten|inklusive|inkl|compris|inclus|compres|inclu[ií]d';
const not = 'not|no|nicht|ohne|keine|without|add|hinzu|non|sans|senza|sin|añad|ajout|aggiung';

const length =
  /(\d{1,2}(?:[.,]\d{1,3})?|\d{1,2}\s?[/⁄]\s?\d{1,2})\s?(mm|cm|in(?:ch(?:es)?)?\b|"|″|”)/i;
const cm: Readonly<Record<string, number>> = {mm: 0.1, cm: 1};

function lengthIn(text: string): number | undefined {
  const [, number, unit = ''] = length.exec(text) ?? [];
  if (number === undefined) return undefined;
  const [over = '', under] = number.split(/[/⁄]/);
  const value = Number(over.replace(',', '.')) / (under === undefined ? 1 : Number(under));
  const result = value * (cm[unit.toLowerCase()] ?? 2.54);
  return result > 0 && result <= 5 ? result : undefined;
}

/** The allowance that texts say is included; 0 if they say that none is; undefined if unsaid. [cm] */
export function statedAllowance(texts: readonly string[]): number | undefined {
  const about = texts.filter((text) => new RegExp(words, 'i').test(text) && text.length < 300);
  for (const text of about) {
    if (!new RegExp(included, 'i').test(text)) continue;
    if (new RegExp(`(?:^|[^\\p{L}])(?:${not})`, 'iu').test(text)) return 0;
    const found = lengthIn(text);
    if (found !== undefined) return found;
  }
  return undefined;
}
