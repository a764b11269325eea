/** Reads CSS colours. */

/** Red, green and blue, from 0 to 1. */
export type Colour = readonly [number, number, number];

const named: Readonly<Record<string, string>> = {
  ...{black: '000000', white: 'ffffff', red: 'ff0000', lime: '00ff00', blue: '0000ff'},
  ...{yellow: 'ffff00', cyan: '00ffff', aqua: '00ffff', magenta: 'ff00ff', fuchsia: 'ff00ff'},
  ...{gray: '808080', grey: '808080', silver: 'c0c0c0', maroon: '800000', olive: '808000'},
  ...{green: '008000', purple: '800080', teal: '008080', navy: '000080', orange: 'ffa500'},
  ...{darkgray: 'a9a9a9', darkgrey: 'a9a9a9', lightgray: 'd3d3d3', lightgrey: 'd3d3d3'},
  ...{gainsboro: 'dcdcdc', whitesmoke: 'f5f5f5', currentcolor: '000000'},
};

/** The colour; null for none, undefined for values that need a browser, such as gradients. */
export function colourOf(text: string): Colour | null | undefined {
  const word = text.toLowerCase();
  if (word === 'none' || word === 'transparent') return null;
  const hex = /^#([\da-f]{6}|[\da-f]{3})$/.exec(word)?.[1] ?? named[word];
  if (hex !== undefined) {
    const long = hex.length === 3 ? hex.replaceAll(/./g, '$&$&') : hex;
    const part = (k: number): number => parseInt(long.slice(k, k + 2), 16) / 255;
    return [part(0), part(2), part(4)];
  }
  const parts = /^rgb\(\s*([^)]*)\)$/.exec(word)?.[1]?.split(/[\s,]+/);
  const [r, g, b] = (parts ?? []).map((part) =>
    part.endsWith('%') ? Number(part.slice(0, -1)) / 100 : Number(part) / 255,
  );
  return [r, g, b].every((part) => part !== undefined && part >= 0 && part <= 1)
    ? [r ?? 0, g ?? 0, b ?? 0]
    : undefined;
}
