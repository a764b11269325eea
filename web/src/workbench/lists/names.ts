/** Words of names. */

export const firstUpper = (words: string): string =>
  words.charAt(0).toLocaleUpperCase() + words.slice(1);

/** The words that two names share, in their order: "Front to Side" of "Front to Side left". */
export function commonWords(one: string, other: string): string {
  const [words, left] = [one.split(' '), other.split(' ')];
  const isShared = words.map((word) => {
    const at = left.indexOf(word);
    if (at >= 0) left.splice(0, at + 1);
    return at >= 0;
  });
  const shared = words.flatMap((word, k) => {
    if (!isShared[k]) return [];
    return isShared[k + 1] === false ? [word.replace(/,$/, '')] : [word];
  });
  return shared.length > 0 ? firstUpper(shared.join(' ')) : one;
}
