/**
 * Frames, joint marks and page names, which help to glue pages together. Lengths in cm on the
 * sheet.
 */
import type {Point} from '../model/geometry/vectors.js';
import type {Box} from '../model/geometry/polyline.js';
import {box, filledWith, line, nums, scoped, strokedWith} from '../files/pdf/content.js';
import type {PdfResources} from '../files/pdf/resources.js';
import {textAt, widthOf} from '../files/pdf/text.js';
import type {Writing} from './writing.js';
import type {PageLayout, SheetPage} from './pages.js';

const frameLine = 0.02;
const diamond = 0.4;
const jointSize = 0.32;
const footSize = 0.26;
/** Height of the footer's baseline above the edge of the page. */
const footRise = 0.55;
const nameSize = 0.6;
const grey = strokedWith([0.45, 0.45, 0.45]);
const white = filledWith([1, 1, 1]);
const black = filledWith([0, 0, 0]);

type Neighbour = (row: number, column: number) => SheetPage | undefined;

/**
 * A diamond on a joint, half of which is on each page, and the names of the joined pages beside its
 * halves.
 */
function joint(
  resources: PdfResources,
  [x, y]: Point,
  [before, after]: readonly [string, string],
  isUpright: boolean,
): string {
  const d = diamond;
  const shape = line(
    [
      [x - d, y],
      [x, y - d],
      [x + d, y],
      [x, y + d],
    ],
    true,
  );
  const angle = isUpright ? 0 : -Math.PI / 2;
  const beside = (side: 1 | -1): Point =>
    isUpright ? [x + side * 0.12, y + d + 0.15] : [x + d + 0.15, y - side * 0.12];
  const style = {size: jointSize, angle};
  const long = jointSize * Math.max(widthOf(before), widthOf(after)) + 0.2;
  const tall = jointSize + 0.1;
  const ground = isUpright
    ? box([x - long, y + d + 0.08], 2 * long, tall)
    : box([x + d + 0.08, y - long], tall, 2 * long);
  return [
    `${white}\n${shape}\nB`,
    `${ground}\nf\n${black}`,
    textAt(resources, beside(-1), before, {...style, align: 'right'}),
    textAt(resources, beside(1), after, {...style, align: 'left'}),
  ].join('\n');
}

/** The page name, large enough to arrange pages on a floor. */
function drawnName(name: string, {low, high}: Box, resources: PdfResources): string {
  const [width, height] = [nameSize * widthOf(name, 'bold') + 0.3, 1.3 * nameSize];
  const at: Point = [low[0], high[1] - height];
  return [
    `${white}\n${box(at, width, height)}\nB\n${black}`,
    textAt(resources, [at[0] + 0.15, at[1] + 0.3 * nameSize], name, {
      ...{size: nameSize, weight: 'bold'},
    }),
  ].join('\n');
}

/**
 * Draws the frame, along which the left and upper edges of a page are cut before it is glued over
 * another. Its white grounds belong beneath the lines of the pieces.
 */
export function drawFrame(page: SheetPage, layout: PageLayout, resources: PdfResources): string {
  const {name, row, column, frame, window} = page;
  if (name === undefined || layout.columns * layout.rows === 1) return '';
  const at: Neighbour = (r, c) =>
    layout.pages.find((one) => one.name !== undefined && one.row === r && one.column === c);
  const {low, high} = frame;
  const [middleX, middleY] = [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2];
  const beside = [
    {other: at(row, column - 1), on: [low[0], middleY] as const, isFirst: false, isUpright: true},
    {other: at(row, column + 1), on: [high[0], middleY] as const, isFirst: true, isUpright: true},
    {other: at(row - 1, column), on: [middleX, high[1]] as const, isFirst: false, isUpright: false},
    {other: at(row + 1, column), on: [middleX, low[1]] as const, isFirst: true, isUpright: false},
  ];
  return scoped(
    `${nums(frameLine)} w`,
    grey,
    `${box(low, high[0] - low[0], high[1] - low[1])} S`,
    `[${nums(0.1, 0.1)}] 0 d`,
    `${box(window.low, window.high[0] - window.low[0], window.high[1] - window.low[1])} S`,
    '[] 0 d',
    drawnName(name, frame, resources),
    ...beside.map(({other, on, isFirst, isUpright}) => {
      if (other?.name === undefined) return '';
      const names = isFirst ? ([name, other.name] as const) : ([other.name, name] as const);
      return joint(resources, on, names, isUpright);
    }),
  );
}

/** Shortens a text to fit. */
function fitting(text: string, room: number): string {
  if (footSize * widthOf(text) <= room) return text;
  const letters = Array.from(text);
  while (letters.length > 0 && footSize * widthOf(`${letters.join('')}…`) > room) letters.pop();
  return `${letters.join('')}…`;
}

/** Draws the footer: the file's description and the page number. */
export function drawFoot(
  {low, name, window}: Pick<SheetPage, 'low' | 'name' | 'window'>,
  words: string,
  {number, count}: {readonly number: number; readonly count: number},
  {resources, texts}: Writing,
): string {
  const y = low[1] + footRise;
  const which = [...(name === undefined ? [] : [name]), texts.page(number, count)].join('  ·  ');
  const room = window.high[0] - window.low[0] - footSize * widthOf(which) - 1;
  return [
    textAt(resources, [window.low[0], y], fitting(words, room), {size: footSize}),
    textAt(resources, [window.high[0], y], which, {size: footSize, align: 'right'}),
  ].join('\n');
}
