/** Content of the first page: text, test squares, and a map of the pages. Lengths in cm, y up. */
import {leastLetterMm, type CutSheet} from '../cutting/cut-sheet.js';
import {plus, type Point} from '../model/geometry/vectors.js';
import {boxOf, type Box} from '../model/geometry/polyline.js';
import {box, filledWith, line, nums, scoped, strokedWith} from '../files/pdf/content.js';
import {cornersOf} from './boxes.js';
import {textAt, widthOf} from '../files/pdf/text.js';
import type {PdfResources} from '../files/pdf/resources.js';
import type {PageLayout} from './pages.js';
import type {Paper} from './papers.js';

const inch = 2.54;
const gap = 0.5;
/** Distance of facts from the heading. */
const belowHeading = 0.16;
const squareSides = [5, 2 * inch];
const squareWords = ['5 cm', '2 in'];
/** Least height of the map. */
const leastMap = 7;
const mapLine = 0.02;
/** Greatest scale of the map, at which a page of a home printer is some centimetres large. */
const mostScale = 0.2;

/** Sizes of text, and the greatest width of the heading. */
interface TextSizes {
  readonly heading: number;
  readonly fact: number;
  readonly leading: number;
  readonly square: number;
  readonly mostHeading: number;
}

const onPaper: TextSizes = {heading: 0.6, fact: 0.34, leading: 0.5, square: 0.5, mostHeading: 17};
/** Letters of 15 mm and more, since a pixel of a projector is about a millimetre. */
const onTable: TextSizes = {heading: 2, fact: 1.5, leading: 2.1, square: 1.5, mostHeading: 60};

const sizesOn = ({isProjector = false}: Paper): TextSizes => (isProjector ? onTable : onPaper);

/** Facts below the heading. A projector shows that of the print alone, since nothing is glued. */
const factsOn = ({isProjector = false}: Paper, {facts, pieces}: CutSheet): readonly string[] =>
  isProjector ? facts.slice(0, pieces.some(({alignment}) => alignment) ? 1 : 0) : facts;

/** Shortens a heading that is too long, with an ellipsis. */
function fitting(heading: string, {heading: size, mostHeading}: TextSizes): string {
  const letters = Array.from(heading);
  const isWider = (text: string): boolean => size * widthOf(text, 'bold') > mostHeading;
  if (!isWider(heading)) return heading;
  let count = letters.length;
  while (count > 1 && isWider(`${letters.slice(0, count).join('')}…`)) count--;
  return `${letters.slice(0, count).join('').trimEnd()}…`;
}

/** A square that verifies the print scale. */
interface TestSquare {
  readonly low: Point;
  readonly side: number;
}

/** Distance of the first fact's baseline from the top. */
const firstFact = ({heading, fact}: TextSizes): number => heading + fact + belowHeading;

/** Height of the text, without squares and map. */
const wordsHeight = (facts: readonly string[], sizes: TextSizes): number =>
  firstFact(sizes) + sizes.leading * facts.length;

/** Least size of the text and squares, and of a map for several pages. */
export function roomOf(sheet: CutSheet, paper: Paper, hasMap: boolean): Point {
  const sizes = sizesOn(paper);
  const facts = factsOn(paper, sheet);
  const width = Math.max(
    squareSides.reduce((sum, side) => sum + side + gap, -gap),
    sizes.heading * widthOf(fitting(sheet.heading, sizes), 'bold'),
    ...facts.map((fact) => sizes.fact * widthOf(fact)),
  );
  const height = wordsHeight(facts, sizes) + 2 * gap + Math.max(...squareSides);
  return [width, height + (hasMap ? gap + leastMap : 0)];
}

/** Test squares from the block's lower left corner. */
export const testSquares = ({low}: Box): readonly TestSquare[] =>
  squareSides.map((side, k) => ({
    side,
    low: plus(low, [k * ((squareSides[0] ?? 0) + gap), 0]),
  }));

function drawnSquares(block: Box, size: number, resources: PdfResources): string {
  return testSquares(block)
    .map(({low, side}, k) => {
      const middle = plus(low, [side / 2, side / 2 - 0.3 * size]);
      return [
        `${nums(0.03)} w`,
        box(low, side, side),
        'S',
        textAt(resources, middle, squareWords[k] ?? '', {size, align: 'middle'}),
      ].join('\n');
    })
    .join('\n');
}

const grey = strokedWith([0.45, 0.45, 0.45]);

/** The pages with their names over the outlines of the pieces; omitted pages are crossed out. */
function drawnMap(
  {pieces}: CutSheet,
  {pages, empty}: PageLayout,
  room: Box,
  resources: PdfResources,
): string {
  const named = pages.filter(({name}) => name !== undefined);
  const {low, high} = boxOf([...named.map(({frame}) => frame), ...empty].flatMap(cornersOf));
  const scale = Math.min(
    (room.high[0] - room.low[0]) / (high[0] - low[0]),
    (room.high[1] - room.low[1]) / (high[1] - low[1]),
    mostScale,
  );
  const onMap = ([x, y]: Point): Point => [
    room.low[0] + (x - low[0]) * scale,
    room.high[1] - (high[1] - y) * scale,
  ];
  const frame = (one: Box): string => `${line(cornersOf(one).map(onMap), true)}\nS`;
  const crossed = ({low: a, high: b}: Box): string =>
    [[a, b] as const, [[a[0], b[1]] as const, [b[0], a[1]] as const]]
      .map((ends) => `${line(ends.map(onMap))}\nS`)
      .join('\n');
  return [
    scoped(
      `${nums(mapLine)} w`,
      grey,
      ...named.map((page) => frame(page.frame)),
      ...empty.flatMap((one) => [frame(one), crossed(one)]),
    ),
    `${nums(1.5 * mapLine)} w`,
    ...pieces.flatMap(({cut}) => cut.map((loop) => `${line(loop.map(onMap), true)}\nS`)),
    ...named.map(({name = '', frame: {low: a, high: b}}) => {
      const size = Math.max(
        leastLetterMm / 10,
        Math.min(0.4, 0.25 * scale * Math.min(b[0] - a[0], b[1] - a[1])),
      );
      const at = plus(onMap([a[0], b[1]]), [0.3 * size, -size]);
      const width = size * widthOf(name, 'bold');
      // covers outlines, which would strike the name through
      const plate = box(plus(at, [-0.15 * size, -0.15 * size]), width + 0.3 * size, size);
      return [
        scoped(filledWith([1, 1, 1]), plate, 'f'),
        textAt(resources, at, name, {size, weight: 'bold'}),
      ].join('\n');
    }),
  ].join('\n');
}

/** Draws text at the top, squares at the bottom and the map between them. */
export function drawFirstPage(
  sheet: CutSheet,
  layout: PageLayout,
  resources: PdfResources,
): string {
  const {block, paper} = layout;
  const sizes = sizesOn(paper);
  const facts = factsOn(paper, sheet);
  const [left, top] = [block.low[0], block.high[1]];
  const words = facts.map((fact, k) =>
    textAt(resources, [left, top - firstFact(sizes) - sizes.leading * k], fact, {
      size: sizes.fact,
    }),
  );
  const hasMap = layout.pages.filter(({name}) => name !== undefined).length > 1;
  const room: Box = {
    low: plus(block.low, [0, Math.max(...squareSides) + gap]),
    high: plus(block.high, [0, -wordsHeight(facts, sizes)]),
  };
  return [
    textAt(resources, [left, top - 0.8 * sizes.heading], fitting(sheet.heading, sizes), {
      ...{size: sizes.heading, weight: 'bold'},
    }),
    ...words,
    drawnSquares(block, sizes.square, resources),
    hasMap ? drawnMap(sheet, layout, room, resources) : '',
  ].join('\n');
}
