/** Returns how strokes of an SVG are painted: not at all, faintly, or as lines for help. */
import type {Drawn} from './walk.js';

/** Returns whether a shape is painted by its stroke or its fill. */
export const isPainted = ({style}: Drawn): boolean =>
  style.stroke !== 'none' || style.fill !== 'none';

/** Greatest opacity of a faint line. */
const faint = 0.3;

/** Least lightness of a grey line, from 0 to 1. */
const light = 0.45;

/** Returns whether a line is dashed, nearly transparent, or grey. */
export const isFaint = ({style}: Drawn): boolean =>
  style.isDashed || style.opacity < faint || (style.stroke !== 'none' && isGrey(style.stroke));

const greys: Readonly<Record<string, number>> = {
  ...{gray: 0.5, grey: 0.5, silver: 0.75, darkgray: 0.66, darkgrey: 0.66},
  ...{lightgray: 0.83, lightgrey: 0.83, gainsboro: 0.86, whitesmoke: 0.96},
};

/** Returns whether a colour is a light grey. */
function isGrey(colour: string): boolean {
  const named = greys[colour];
  if (named !== undefined) return named >= light;
  const [, hex = ''] = /^#((?:[\da-f]{3}){1,2})$/i.exec(colour) ?? [];
  const size = hex.length / 3;
  const levels =
    size > 0
      ? [0, 1, 2].map((k) => parseInt(hex.slice(k * size, (k + 1) * size).repeat(3 - size), 16))
      : (/^rgb\(\s*(\d+)[\s,]+(\d+)[\s,]+(\d+)\s*\)$/.exec(colour) ?? []).slice(1).map(Number);
  const [low, high] = [Math.min(...levels), Math.max(...levels)];
  return levels.length === 3 && high - low <= 8 && low >= 255 * light && high < 250;
}

const helpWords =
  /(?:^|[^a-z])(?:test ?)?(?:grids?(?:line)?|test|frame|border|guides?|rahmen|hilfslinien?)(?:$|[^a-z])/i;

/** Returns whether the name of a line, or of a group around it, is that of a line for help. */
export const isForHelp = ({element, groups}: Drawn): boolean =>
  [element, ...groups].some(({attributes}) =>
    ['id', 'inkscape:label', 'class', 'data-name'].some((name) =>
      helpWords.test((attributes.get(name) ?? '').replaceAll(/[_.-]/g, ' ')),
    ),
  );
