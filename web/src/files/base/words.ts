/** Recognises text on pieces in the five languages, and in those of pattern programs. */

/** Number of pieces to cut. */
export interface Count {
  readonly asDrawn: number;
  readonly mirrored: number;
}

const cutWords =
  'cut|cutting|coupe[rz]?|tailler|schneiden|zuschneiden|tagliar?e?|taglia|cort[ae]r?|cortad|knip(?:pen)?';
const foldWords =
  /on (?:the )?fold|on ?fold|cut on fold|fold line|(?<!um)(?:stoff)?bruch|(?:au|sur(?: le| la)?|dans le) pli(?:ure)?|(?:in|sul|sulla|su) (?:doppi[ao]|piega)|(?:al|en el|sobre(?: el)?|en) (?:doblez|doble|pliegue|lomo)|aan de vouw/i;
const pairWords =
  /mirror|\bpairs?\b|\bpaire?\b|\bpaare?\b|gegengleich|gespiegelt|coppi[ae]|specular|sym[eé]tri|sim[eé]tric|espejo|\bl ?(?:\+|&|and) ?r\b|left and right/i;

const word = `(?:${cutWords})`;
/** Matches "Cut 2", "cut: 1 pair", "2 x zuschneiden" and "4x". */
const counts = [
  new RegExp(`\\b${word}\\b[^\\d\\n]{0,12}?(\\d{1,2})(?!\\d|[.,]\\d| ?(?:mm|cm|in\\b|"|%))`, 'i'),
  new RegExp(`(?<![\\d.,])(\\d{1,2})\\s*(?:x|×|mal|fois|volte|veces)?\\s*${word}\\b`, 'i'),
  /(?:^|\s)(\d{1,2})\s?[x×](?=\s|$)|(?:^|\s)[x×]\s?(\d{1,2})(?=\s|$)/i,
];

const pairsOf = /\d\s*(?:x\s*)?(?:pairs?|paare?|paires?|coppi[ae]|par(?:es)?)\b/i;
const sameWords = /identi[ck]|gleich(?!gewicht)|same|ugual|igual|single layer/i;

/**
 * The number of pieces in a text; undefined if there is none. An even number is cut from folded
 * fabric in mirrored pairs, unless the piece is on the fold or the text calls the pieces identical.
 */
export function countOf(words: readonly string[]): Count | undefined {
  for (const text of words) {
    const found = counts.map((one) => one.exec(text)).find((one) => one !== null);
    const isPair = pairWords.test(text);
    const said = Number(found?.slice(1).join('') ?? NaN);
    if (Number.isNaN(said) && !(isPair && new RegExp(`\\b${word}\\b`, 'i').test(text))) continue;
    const all = Number.isNaN(said) ? 1 : said;
    if (all < 1) continue;
    // one pair is two pieces
    if (isPair && (all === 1 || pairsOf.test(text))) return {asDrawn: all, mirrored: all};
    const isAlike = !isPair && (sameWords.test(text) || saysFold([text]) || all % 2 === 1);
    return isAlike
      ? {asDrawn: all, mirrored: 0}
      : {asDrawn: Math.ceil(all / 2), mirrored: Math.floor(all / 2)};
  }
  return undefined;
}

/** Returns whether the text describes a half piece on the fold. */
export const saysFold = (words: readonly string[]): boolean =>
  words.some((one) => foldWords.test(one));

/** Returns whether the text names the grain line. */
export const saysGrain = (words: readonly string[]): boolean =>
  words.some((one) =>
    /grain|fadenlauf|droit[- ]fil|dritto ?filo|filo|hilo|draadrichting/i.test(one),
  );

const dateOrCompany =
  /\b(?:mon|tues|wednes|thurs|fri|satur|sun)day\b|\b(?:jan|feb|mar|apr|may|jun|jul|aug|sep|oct|nov|dec)[a-z]*\.? \d{1,2}\b|\b\d{4}-\d\d-\d\d\b|\b(?:gmbh|inc|ltd|llc|s\.?r\.?l|s\.?a\.?s)\b\.?|©|copyright|www\.|https?:/i;

/** Returns whether a text is no name: a count, size, length, date or company. */
export const isNoName = (line: string): boolean =>
  countOf([line]) !== undefined ||
  saysFold([line]) ||
  saysGrain([line]) ||
  /^[\W\d_]*$|^\W*\d+([.,]\d+)?\s*(?:mm|cm|in|inch(?:es)?|"|″)|^(?:size|gr[öo]sse|größe|taille|taglia|talla|scale)\b/i.test(
    line,
  ) ||
  dateOrCompany.test(line) ||
  !/\p{L}{2}/u.test(line);
