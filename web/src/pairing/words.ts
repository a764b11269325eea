/** What the name of a piece says of where it is worn: left, right, front, back, and whether it is a sleeve. */

export interface Words {
  /** 1: left, -1: right, 0: not said. */
  readonly side: -1 | 0 | 1;
  /** 1: front, -1: back, 0: not said. */
  readonly face: -1 | 0 | 1;
  readonly isSleeve: boolean;
}

/** In the languages of the page. */
const sleeve = /sleeve|armel$|aermel$|^manches?$|^mangas?$|^manic[ah]e?$/;

/** `frontLeft`, `front_left` and `Lfront` name the same. */
const partsOf = (name: string): readonly string[] =>
  name
    .normalize('NFD')
    .replaceAll(/\p{M}/gu, '')
    .replaceAll(/([a-z])([A-Z])/g, '$1 $2')
    .replaceAll(/\b([LR])(?=[a-z]{3})/g, '$1 ')
    .replaceAll(/(?<![a-z])([lr])([fb])(?=sleeve)/g, '$1 $2 ')
    .toLowerCase()
    .split(/[^a-z]+/);

/** 1 where a name has a word, or begins with its letter and goes on with another; -1 for the opposite; 0 for neither and both. */
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
