/**
 * Reads from a piece's name where it is worn: left, right, front or back, and whether it is a
 * sleeve.
 */

export interface Words {
  /** 1: left, -1: right, 0: unknown. */
  readonly side: -1 | 0 | 1;
  /** 1: front, -1: back, 0: unknown. */
  readonly face: -1 | 0 | 1;
  readonly isSleeve: boolean;
}

/** Sleeve in the languages of the page. */
const sleeve = /sleeve|armel$|aermel$|^manches?$|^mangas?$|^manic[ah]e?$/;

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
  return {
    side: sign(parts, /^l$|left/, /^r$|right/),
    face: sign(parts, /^ft?$|front|^ftorso/, /^bt?$|back|^btorso/),
    isSleeve: parts.some((part) => sleeve.test(part)),
  };
}
