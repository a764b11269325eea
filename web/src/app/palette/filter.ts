/** Searches commands by a few words. */
import type {Command} from '../../commands/editor-command.js';

/** Folds a text for comparison: no capitals and no diacritics. */
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

/**
 * Returns the rank of a command, 0 best; undefined if a word does not occur. Unavailable commands
 * come after available ones.
 */
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

/**
 * Returns the commands that contain all typed words, whole or in part, the best first, otherwise in
 * their own order.
 */
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
