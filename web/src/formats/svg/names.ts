/** What pieces are called: by the words in them, by their ids and labels. */
import {countOf, saysFold, saysGrain} from '../base/words.js';
import type {XmlElement} from '../base/xml.js';
import type {DrawnText} from './walk.js';

/** Words that say something else than a name: counts, sizes, lengths, dates. */
const isNoName = (line: string): boolean =>
  countOf([line]) !== undefined ||
  saysFold([line]) ||
  saysGrain([line]) ||
  /^[\W\d_]*$|^\W*\d+([.,]\d+)?\s*(?:mm|cm|in|inch(?:es)?|"|″)|^(?:size|gr[öo]sse|größe|taille|taglia|talla|scale)\b/i.test(
    line,
  ) ||
  !/\p{L}{2}/u.test(line);

/** The largest words among those that may be a name; of equal ones, or in order, the first. */
export function titled(texts: readonly DrawnText[], inOrder: boolean): string | undefined {
  const named = texts.flatMap(({lines, size}) => {
    const line = lines.find((one) => !isNoName(one));
    return line === undefined ? [] : [{line, size}];
  });
  const largest = inOrder ? 0 : Math.max(...named.map(({size}) => size));
  return named.find(({size}) => size >= 0.98 * largest)?.line;
}

/** Ids that programs make up. */
const madeUp =
  /^(?:path|rect|polygon|polyline|ellipse|circle|line|g|group|svg|layer|ebene|calque|livello|capa|use|shape|surface|page|text|object|element|svgid|clip|_)?[-_ \d]*(?:copy)?[-_ \d]*$/i;

/** What people called an element; undefined where they did not. */
export function labelOf({attributes, children}: XmlElement): string | undefined {
  const title = children.find((child) => typeof child !== 'string' && child.name === 'title');
  const titleText =
    typeof title === 'object'
      ? title.children.filter((one) => typeof one === 'string').join('')
      : '';
  const names = [
    ...['inkscape:label', 'data-name', 'aria-label'].map((name) => attributes.get(name)),
    titleText,
    // Illustrator writes what an id may not have as its code
    attributes
      .get('id')
      ?.replaceAll(/_x([\dA-F]{2})_/g, (_, hex: string) => String.fromCharCode(parseInt(hex, 16))),
  ];
  return names
    .map((name) => (name ?? '').replaceAll(/[_\s]+/g, ' ').trim())
    .find((name) => name !== '' && name.length <= 80 && !madeUp.test(name));
}
