/**
 * Names of a garment's pieces for the user. Files, options and results use the names of the panels.
 */

/** Chosen names, by the names of the panels. */
export type PieceNames = Readonly<Record<string, string>>;

/** GarmentCode labels panels by the part of the body that they cover, so many labels are equal. */
const bodyParts = new Set(['body', 'torso', 'arm', 'leg', 'head', 'hand', 'foot', 'panel']);

/** Abbreviations in existing files: those of GarmentCode, and of the templates before it. */
const abbreviations: Readonly<Record<string, string>> = {
  f: 'front',
  b: 'back',
  l: 'left',
  r: 'right',
  sl: 'sleeve',
  wb: 'waistband',
  pant: 'trouser leg',
};
/** Matches "ftorso", "lfsleeve", "Rback". */
const joined = /^(l|r)?(f|b)?(torso|sleeve|hood|cuff|collar|pant)$|^(l|r)(front|back)$/i;

const expanded = (word: string): string => abbreviations[word.toLowerCase()] ?? word;

/** Letters of opposite sides. */
const opposite: Readonly<Record<string, string>> = {f: 'b', b: 'f', l: 'r', r: 'l'};

function wordsOf(token: string, isSide: boolean): string {
  const groups: readonly (string | undefined)[] = joined.exec(token)?.slice(1) ?? [];
  const parts = groups.flatMap((part) => part ?? []);
  if (parts.length > 1) return parts.map((part) => expanded(part.toLowerCase())).join(' ');
  return token.length === 1 && !isSide ? token : expanded(token);
}

const tokensOf = (key: string): string[] => key.split(/[\s_.-]+/).filter((token) => token !== '');

/**
 * Converts a key to words: "left_ftorso" to "Left front torso". Single letters are sides in keys of
 * GarmentCode, which have small letters and underscores.
 */
export function readable(key: string): string {
  const tokens = tokensOf(key);
  const isKey = tokens.length > 1 && /^[a-z\d_]+$/.test(key);
  return inWords(key, tokens, () => isKey);
}

function inWords(
  key: string,
  tokens: readonly string[],
  isSide: (token: number) => boolean,
): string {
  const words = tokens.map((token, k) => wordsOf(token, isSide(k))).join(' ');
  return words === '' ? key : words.charAt(0).toUpperCase() + words.slice(1);
}

/**
 * Words for each key. A single letter is a side only if another key has the opposite one at its
 * place, and none has a letter that is no side.
 */
function readableAll(keys: Iterable<string>): (key: string) => string {
  const letters = new Map<string, Set<string>>();
  const stemOf = (tokens: readonly string[], k: number): string => tokens.with(k, '').join('_');
  for (const tokens of [...keys].map(tokensOf)) {
    tokens.forEach((token, k) => {
      if (token.length !== 1) return;
      const stem = stemOf(tokens, k);
      letters.set(stem, (letters.get(stem) ?? new Set()).add(token.toLowerCase()));
    });
  }
  return (key) => {
    const tokens = tokensOf(key);
    return inWords(key, tokens, (k) => {
      const token = tokens[k]?.toLowerCase() ?? '';
      const known = letters.get(stemOf(tokens, k)) ?? new Set<string>();
      const isPaired = tokens.length > 1 && known.has(opposite[token] ?? '');
      return isPaired && [...known].every((letter) => letter in opposite);
    });
  };
}

const countOf = (names: Iterable<string>): ReadonlyMap<string, number> => {
  const count = new Map<string, number>();
  for (const name of names) count.set(name, (count.get(name) ?? 0) + 1);
  return count;
};

/**
 * Names of all panels: the chosen one, or the label if it identifies the piece, or the key in
 * words.
 * @param labels by key, in the order of the file
 */
export function pieceNames(
  labels: ReadonlyMap<string, string | undefined>,
  chosen: PieceNames = {},
): ReadonlyMap<string, string> {
  const words = readableAll(labels.keys());
  const labelCount = countOf([...labels.values()].flatMap((label) => label ?? []));
  const own = new Map(
    [...labels].map(([key, label = '']): [string, string] => {
      const says =
        label.trim() !== '' && labelCount.get(label) === 1 && !bodyParts.has(label.toLowerCase());
      return [key, says ? label : words(key)];
    }),
  );
  const nameCount = countOf(own.values());
  return new Map(
    [...own].map(([key, name]): [string, string] => [
      key,
      (Object.hasOwn(chosen, key) ? chosen[key] : undefined) ??
        (nameCount.get(name) === 1 ? name : key),
    ]),
  );
}

/** Title of a garment from its file name: "Shirt mean" from "shirt_mean_specification.json". */
export function titleOfFile(file: string): string {
  const stem = file
    .replace(/^.*[/\\]/, '')
    .replace(/(\.(json|seamwise|garment|result))+$/i, '')
    .replace(/[_-]?specification$/i, '');
  return readable(stem === '' ? file : stem);
}
