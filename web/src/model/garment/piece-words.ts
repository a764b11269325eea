/**
 * Reads from a piece's name where it is worn: left, right, front or back, its kind, and its number
 * among pieces of the same name.
 */

/** Kinds of pieces that have their own neighbours. */
export type PieceKind =
  'sleeve' | 'cuff' | 'collar' | 'hood' | 'band' | 'skirt' | 'trousers' | 'bodice' | 'pocket';

export interface Words {
  /** 1: left, -1: right, 0: unknown. */
  readonly side: -1 | 0 | 1;
  /** 1: front, -1: back, 0: unknown. */
  readonly face: -1 | 0 | 1;
  readonly isSleeve: boolean;
  /** Undefined if the name contains no word of a kind. */
  readonly kind: PieceKind | undefined;
  /** Last number in the name, such as 3 of `skirt_panel_3`. */
  readonly number: number | undefined;
  /** The name without that number. */
  readonly stem: string;
  /** All words of the name, in lower case and without accents. */
  readonly all: readonly string[];
}

/** Sleeve in the languages of the page. */
const sleeve = /sleeve|armel$|aermel$|^manches?$|^mangas?$|^manic[ah]e?$/;

/** Words of the kinds in the languages of the page; the first match decides. */
const kinds: readonly (readonly [PieceKind, RegExp])[] = [
  ['pocket', /pocket|tasche|^poches?$|bolsillo|^tasc(a|he)$/],
  ['cuff', /cuff|manschette|bundchen|buendchen|^poignets?$|^punos?$|polsin[oi]/],
  ['sleeve', sleeve],
  ['hood', /hood|kapuze|capuche|capucha|cappuccio/],
  ['collar', /collar|kragen|^cols?$|^cuello$|colletto|^stand$|lapel|revers/],
  ['band', /band$|^wb$|^bund$|ceinture|cintur|^belt$|gurtel/],
  ['skirt', /skirt|^rock|^jupes?$|^faldas?$|^gonn[ae]$|^gores?$/],
  ['trousers', /^pants?$|trouser|^hosen?$|^legs?$|pantal|^jambes?$|^bein|^shorts?$|^jeans$/],
  ['bodice', /torso|bodice|^top$|oberteil|corsage|^buste$|corpino|corpetto/],
];

/** Splits a name into words: `frontLeft`, `front_left` and `Lfront` all give a side and a face. */
const partsOf = (name: string): readonly string[] =>
  name
    .normalize('NFD')
    .replaceAll(/\p{M}/gu, '')
    .replaceAll(/([a-z])([A-Z])/g, '$1 $2')
    .replaceAll(/\b([LR])(?=[a-z]{3})/g, '$1 ')
    .replaceAll(/(?<![a-z])([lr])([fb])(?=sleeve)/g, '$1 $2 ')
    .toLowerCase()
    .split(/[^a-z]+/);

/** Returns 1 if a word matches `yes`, -1 if one matches `no`, and 0 for neither or both. */
function sign(parts: readonly string[], yes: RegExp, no: RegExp): -1 | 0 | 1 {
  const [has, hasOpposite] = [yes, no].map((word) => parts.some((part) => word.test(part)));
  if (has === hasOpposite) return 0;
  return has ? 1 : -1;
}

export function wordsOf(name: string): Words {
  const parts = partsOf(name);
  const digits = /\d+(?=\D*$)/.exec(name)?.[0];
  return {
    side: sign(parts, /^l$|left/, /^r$|right/),
    face: sign(parts, /^ft?$|front|^ftorso/, /^bt?$|back|^btorso/),
    isSleeve: parts.some((part) => sleeve.test(part)),
    kind: kinds.find(([, word]) => parts.some((part) => word.test(part)))?.[0],
    number: digits === undefined ? undefined : Number(digits),
    stem: name.replace(/\d+(?=\D*$)/, '#'),
    all: parts.filter((part) => part !== ''),
  };
}
