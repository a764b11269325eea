/** Which commands somebody means by a few words. */
import type {Command} from '../../editor/index.js';

/** As it is compared: without capitals and diacritics. */
export const folded = (text: string): string =>
  text
    .normalize('NFD')
    .replace(/\p{M}/gu, '')
    .toLowerCase()
    .replaceAll('ß', 'ss')
    .replaceAll('œ', 'oe')
    .replaceAll('æ', 'ae');

const wordsIn = (text: string): readonly string[] =>
  folded(text)
    .split(/[^\p{L}\p{N}]+/u)
    .filter((word) => word !== '');

/** How well all words fit, 0 best; undefined when one does not occur. What cannot be done now comes after what can. */
function rank({title, words = '', why}: Command, wanted: readonly string[]): number | undefined {
  const named = wordsIn(title);
  const called = wordsIn(words);
  const ranks = wanted.map((word) => {
    if (named.some((one) => one.startsWith(word))) return 0;
    if (called.some((one) => one.startsWith(word))) return 1;
    return [...named, ...called].some((one) => one.includes(word)) ? 2 : 3;
  });
  const worst = Math.max(0, ...ranks);
  if (worst === 3) return undefined;
  return worst + (why === undefined ? 0 : 3);
}

/** Those in which every word that was typed occurs, whole or in part; nearest first, else in their own order. */
export function matching(commands: readonly Command[], typed: string): readonly Command[] {
  const wanted = wordsIn(typed);
  if (wanted.length === 0) return commands;
  return commands
    .flatMap((command) => {
      const fit = rank(command, wanted);
      return fit === undefined ? [] : [{command, fit}];
    })
    .sort((a, b) => a.fit - b.fit)
    .map(({command}) => command);
}
