/** Returns how strokes of an SVG are painted: not at all, faintly, or as lines for help. */
import {colourOf} from '../base/colours.js';
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

/** Returns whether a colour is a light grey. */
function isGrey(colour: string): boolean {
  const levels = colourOf(colour);
  if (!levels) return false;
  const [low, high] = [Math.min(...levels), Math.max(...levels)];
  return high - low <= 8 / 255 && low >= light && high < 250 / 255;
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
