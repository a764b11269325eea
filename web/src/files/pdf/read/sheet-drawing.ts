/**
 * Converts an assembled sheet to the drawing from which pieces are read: joined lines with hints of
 * their roles, and texts. Lengths in mm.
 */
import {minus, unit} from '../../../model/geometry/vectors.js';
import {boxOf} from '../../../model/geometry/polyline.js';
import {arrowsIn} from '../../base/arrows.js';
import type {XmlElement} from '../../base/xml.js';
import {straightLine} from '../../svg/outlines.js';
import type {Drawn, DrawnText, Sheet as DrawnSheet} from '../../svg/walk.js';
import type {Sheet} from './assemble.js';
import {middleOf, type InkLine, type InkStyle, type InkText} from './ink.js';
import {isHelpLayer, statedRole} from './layer-words.js';
import {byStyle, joinedLines, styleKey} from './styles.js';

const elementOf = (name?: string): XmlElement => ({
  name: 'path',
  attributes: new Map(name === undefined ? [] : [['data-name', name]]),
  children: [],
});

/** Open lines share an element, since a page may have a hundred thousand. */
const openElement = elementOf();

/** The parts of a drawn line that all lines of a style share. */
type Look = Required<Pick<Drawn, 'groups' | 'style' | 'hints'>>;

function lookOf(style: InkStyle): Look {
  const {stroke = 'none', isFilled, opacity, layer} = style;
  const stated = layer === undefined ? undefined : statedRole(layer);
  return {
    groups: [],
    style: {
      ...{stroke, fill: isFilled ? '#000000' : 'none', isHidden: false, isDashed: false},
      ...{opacity, isEvenOdd: false, fontSize: 1},
    },
    hints: {...(stated && {stated}), style: styleKey(style)},
  };
}

/** Draws lines, with one look for each style. */
function drawnLines(lines: readonly InkLine[]): Drawn[] {
  const looks = new Map<InkStyle, Look>();
  return lines.map(({points, isClosed, style}) => {
    const look = looks.get(style) ?? lookOf(style);
    looks.set(style, look);
    const element = isClosed ? elementOf() : openElement;
    return {...look, element, lines: [straightLine(points, isClosed)], isUsed: false};
  });
}

const textOf = ({text, size, ...ends}: InkText): DrawnText => ({
  ...{element: elementOf(), groups: [], lines: [text], size},
  ...{at: middleOf({text, size, ...ends}), along: unit(minus(ends.to, ends.from))},
});

/** Text along a line repeats its words from end to end, and names no piece. */
const isRepeated = (text: string): boolean => /(.{4,80}?)\s*\1\s*\1/.test(text.slice(0, 300));

/** The drawing of a sheet; lines for help and arrowheads are left out. */
export function drawingOf(
  {lines, texts}: Pick<Sheet, 'lines' | 'texts'>,
  program?: string,
): DrawnSheet {
  const useful = lines.filter(({style: {layer}}) => layer === undefined || !isHelpLayer(layer));
  const {arrows, rest} = arrowsIn(useful);
  const joined = [...byStyle(rest).values()].flatMap(joinedLines);
  const {low, high} = boxOf(joined.flatMap(({points}) => points));
  return {
    drawn: [
      ...drawnLines(joined),
      ...drawnLines(arrows.map((arrow) => ({...arrow, isClosed: false}))).map((arrow) => ({
        ...arrow,
        element: elementOf('grainline'),
      })),
    ],
    texts: texts
      .filter(({layer, text}) => (layer === undefined || !isHelpLayer(layer)) && !isRepeated(text))
      .map(textOf),
    symbols: [],
    notes: [],
    page: [high[0] - low[0] + 1000, high[1] - low[1] + 1000],
    ...(program !== undefined && {program}),
  };
}
