/** Sizes of paper. [cm] */

/** A paper in portrait orientation. */
export interface Paper {
  /** Displayed name. */
  readonly name: string;
  readonly widthCm: number;
  /** Undefined for a roll, which is as long as needed. */
  readonly heightCm?: number;
  /** One page as large as its content, for a projector. */
  readonly isProjector?: boolean;
  /** Keeps blank pages, for programs that join the pages row by row. */
  readonly keepsBlank?: boolean;
}

const inch = 2.54;
const inches = (name: string, width: number, height: number): Paper => ({
  ...{name, widthCm: width * inch, heightCm: height * inch},
});

const papers: Readonly<Record<string, Paper>> = {
  a4: {name: 'A4', widthCm: 21, heightCm: 29.7},
  letter: inches('Letter', 8.5, 11),
  a3: {name: 'A3', widthCm: 29.7, heightCm: 42},
  legal: inches('Legal', 8.5, 14),
  tabloid: inches('Tabloid', 11, 17),
  a2: {name: 'A2', widthCm: 42, heightCm: 59.4},
  a1: {name: 'A1', widthCm: 59.4, heightCm: 84.1},
  a0: {name: 'A0', widthCm: 84.1, heightCm: 118.9},
  '36in': {name: '36 in roll', widthCm: 36 * inch},
  projector: {name: 'projector', widthCm: 0, isProjector: true},
};

export const noPaper = (word: string): string =>
  `there is no paper '${word}'; name one of ${Object.keys(papers).join(', ')}, or a size from 12 cm to 5 m, such as 60x90cm or 24x36in.`;

const units: Readonly<Record<string, number>> = {mm: 0.1, cm: 1, in: inch};
/**
 * Limits of a side: below, there is no room for the test squares; above, viewers do not display the
 * page.
 */
const least = 12;
const most = 500;

/**
 * A paper by name, or by size in cm or another unit, such as `60x90`, `600x900mm` or `24x36in`;
 * undefined if unknown.
 */
export function paperOf(word: string): Paper | undefined {
  const known = word.toLowerCase();
  if (Object.hasOwn(papers, known)) return papers[known];
  const size = /^(\d+(?:\.\d+)?)x(\d+(?:\.\d+)?)(mm|cm|in)?$/.exec(known);
  if (!size) return undefined;
  const [, first = '', second = '', unit = 'cm'] = size;
  const sides = [first, second].map((side) => Number(side) * (units[unit] ?? 1));
  const [width, height] = [Math.min(...sides), Math.max(...sides)];
  if (!(width >= least && height <= most)) return undefined;
  return {name: `${first} x ${second} ${unit}`, widthCm: width, heightCm: height};
}
