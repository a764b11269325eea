/** Reads the pieces of FreeSewing files: one group per piece, with line types as classes. [mm] */
import type {DrawnNotch, DrawnPiece} from '../../model/garment/imported-drawing.js';
import type {Point} from '../../model/geometry/vectors.js';
import {atShare, isInside, lengthOf} from '../../model/geometry/polyline.js';
import {endOf} from '../base/bezier.js';
import {runsOf} from '../base/edges.js';
import {countOf, type Count} from '../base/words.js';
import {nearestOn} from '../../model/geometry/nearest.js';
import {cutAround} from './cut-around.js';
import type {Found} from './generic.js';
import type {Line} from './lines.js';
import {areaOf, chained, pointsOf, rimOf} from './outlines.js';
import {classesOf} from './styles.js';
import {hrefOf} from './values.js';
import type {Drawn, DrawnText, Sheet} from './walk.js';
import type {XmlElement} from '../base/xml.js';

/** Materials, which are classes of outlines. */
const materials = ['fabric', 'lining', 'interfacing', 'canvas', 'contrast', 'various'];
/** Classes of lines that are never outlines. */
const marks = ['sa', 'help', 'note', 'mark', 'hidden', 'dashed', 'dotted', 'lashed', 'scalebox'];

const idOf = (element: XmlElement): string => element.attributes.get('id') ?? '';

/** The group of the part that contains an element; a stack draws several parts over each other. */
function partOf(groups: readonly XmlElement[]): XmlElement | undefined {
  const stacks = groups.filter((group) => /(?:^|-)stack-/.test(idOf(group)));
  return stacks.find((group) => idOf(group).includes('-part-')) ?? stacks[0];
}

const hasClass = (element: XmlElement, ...names: readonly string[]): boolean =>
  classesOf(element).some((name) => names.includes(name));

/** The pieces; empty if the file has no FreeSewing groups. Notes name parts without an outline. */
export function freesewingPieces(sheet: Sheet): Found {
  const parts = new Set<XmlElement>();
  for (const {groups} of sheet.drawn) {
    const part = partOf(groups);
    if (part) parts.add(part);
  }
  const within = <T extends {readonly groups: readonly XmlElement[]}>(
    all: readonly T[],
    part: XmlElement,
  ): T[] => all.filter(({groups}) => groups.includes(part));
  const notes: string[] = [];
  const pieces = [...parts].flatMap((part) => {
    const drawn = within(sheet.drawn, part).filter((one) => !one.isUsed);
    const outline = outlineOf(drawn);
    const texts = within(sheet.texts, part);
    if (outline) return [pieceOf(part, outline, drawn, texts, within(sheet.symbols, part))];
    notes.push(`Part '${nameOf(part, texts)}' has no closed outline, and is left out.`);
    return [];
  });
  return {pieces, notes};
}

interface Outline {
  readonly line: Line;
  readonly drawn: Drawn;
}

/**
 * The largest closed line that is sewn; smaller ones are darts. Parts may draw it without a class;
 * without any sewn line, the cut line is the outline.
 */
function outlineOf(drawn: readonly Drawn[]): Outline | undefined {
  const isSewn = ({element}: Drawn): boolean =>
    hasClass(element, ...materials) && !hasClass(element, ...marks);
  const isBare = ({element}: Drawn): boolean => classesOf(element).length === 0;
  const isCut = ({element}: Drawn): boolean =>
    hasClass(element, 'sa') && hasClass(element, ...materials);
  return (
    largest(drawn.filter(isSewn)) ?? largest(drawn.filter(isBare)) ?? largest(drawn.filter(isCut))
  );
}

/** The largest closed line. */
function largest(drawn: readonly Drawn[]): Outline | undefined {
  const closed = drawn.flatMap((one) =>
    one.lines.filter(({isClosed}) => isClosed).map((line) => ({line, drawn: one})),
  );
  const areas = closed.map(({line}) => areaOf(line));
  return closed[areas.indexOf(Math.max(...areas))];
}

function pieceOf(
  part: XmlElement,
  {line, drawn: outline}: Outline,
  drawn: readonly Drawn[],
  texts: readonly DrawnText[],
  symbols: Sheet['symbols'],
): DrawnPiece {
  const rim = rimOf(line);
  const pointing = (marker: string): Line | undefined =>
    drawn.find(({element}) => element.attributes.get('marker-start')?.includes(`#${marker}`))
      ?.lines[0];
  const [fold, grain] = ['cutonfoldFrom', 'grainlineFrom'].map(pointing);
  const words = texts
    .filter(
      ({element}) =>
        !element.children.some((one) => typeof one !== 'string' && one.name === 'textPath'),
    )
    .flatMap(({lines}) => lines);
  const sa = drawn.filter(({element}) => hasClass(element, 'sa')).flatMap(({lines}) => lines);
  const cut = cutAround(line, sa);
  const ends = (one: Line): [Point, Point] => [one.start, endOf(one)];
  const grainLine = grain ?? fold; // the fold mark also marks the grain
  return {
    name: nameOf(part, texts),
    quantity: quantityOf(words),
    material: materialOf(outline.element, drawn),
    sewn: runsOf(line),
    ...(cut && {cut: runsOf(cut)}),
    holes: [],
    notches: symbols.flatMap(({of, at}) => notchAt(of, at, rim)),
    ...(grainLine && {grain: ends(grainLine)}),
    ...(fold && {fold: ends(fold)}),
    ...linesInside(drawn, line, rim, texts),
    drillHoles: symbols.filter(({of}) => /^(?:button|snap|eyelet)/.test(of)).map(({at}) => at),
    words,
  };
}

/**
 * The quantity of a piece. A piece cut in different ways from one material has one line for each.
 */
function quantityOf(words: readonly string[]): Count {
  const bare = (line: string): string => line.replaceAll(/^\W+|\d/g, '');
  const lines = words.flatMap((line) => {
    const count = countOf([line]);
    return count ? [{line: bare(line), count}] : [];
  });
  const [first] = lines;
  if (!first) return {asDrawn: 1, mirrored: 0};
  const alike = lines.filter(({line}) => line === first.line).map(({count}) => count);
  return {
    asDrawn: alike.reduce((sum, {asDrawn}) => sum + asDrawn, 0),
    mirrored: alike.reduce((sum, {mirrored}) => sum + mirrored, 0),
  };
}

/** Greatest distance of a notch from its outline; other symbols are no notches. [mm] */
const onOutline = 1;

function notchAt(of: string, at: Point, rim: readonly Point[]): DrawnNotch[] {
  const isNotch = of === 'notch' || of === 'bnotch';
  return isNotch && nearestOn(rim, at, true).off <= onOutline ? [{at, kind: 'slit'}] : [];
}

function nameOf(part: XmlElement, texts: readonly DrawnText[]): string {
  const title = texts.find(
    ({element}) => hasClass(element, 'text-lg') && hasClass(element, 'font-bold'),
  );
  const [titled = ''] = title?.lines ?? [];
  // a title without a translation is a key
  const isKey = titled === '' || /^[a-z]+[A-Z]/.test(titled) || titled.includes(':');
  const named = isKey ? idOf(part).replace(/^.*[-.]/, '') : titled;
  return inWords(named);
}

/** A name of the program, such as `waistLine`, in words. */
const inWords = (name: string): string =>
  /\s/.test(name) ? name : name.replaceAll(/(?<=[a-z])(?=[A-Z])/g, ' ').toLowerCase();

/** Length below which lines are ticks. [mm] */
const shortest = 10;

/** The text that is written along a line, without its repetitions, such as `waist line`. */
function writtenAlong(line: XmlElement, texts: readonly DrawnText[]): string | undefined {
  const along = texts.find(({element}) =>
    element.children.some(
      (one) =>
        typeof one !== 'string' && one.name === 'textPath' && hrefOf(one) === `#${idOf(line)}`,
    ),
  );
  const words = along?.lines.join(' ').split(' ') ?? [];
  const period = words.findIndex(
    (_, k) => k > 0 && words.every((word, n) => word === words[n % k]),
  );
  const name = words.slice(0, period < 0 ? undefined : period).join(' ');
  return name === '' ? undefined : inWords(name.replace(/^.*:/, ''));
}

/**
 * Other lines inside a piece, with their names: darts, folds and button positions. Hidden lines
 * count if text is written along them.
 */
function linesInside(
  drawn: readonly Drawn[],
  outline: Line,
  rim: readonly Point[],
  texts: readonly DrawnText[],
): Pick<DrawnPiece, 'internalLines' | 'lineNames'> {
  const isShown = (element: XmlElement, name: string | undefined): boolean =>
    !hasClass(element, 'sa', 'scalebox') &&
    !element.attributes.has('marker-start') &&
    (name !== undefined || !hasClass(element, 'hidden'));
  const shown = drawn.flatMap(({element, lines}) => {
    const name = writtenAlong(element, texts);
    return isShown(element, name) ? lines.map((line) => ({line, name})) : [];
  });
  const unnamed = shown.flatMap(({line, name}) => (name === undefined ? [line] : []));
  const joined = chained(unnamed).map(({line}) => ({line, name: undefined}));
  const found = [...joined, ...shown.filter(({name}) => name !== undefined)]
    .filter(({line}) => line.start !== outline.start || !line.isClosed)
    .map(({line, name}) => ({points: pointsOf(line), name}))
    .filter(({points}) => lengthOf(points) >= shortest && isInside(rim, atShare(points, 0.5).at));
  return {
    internalLines: found.map(({points}) => points),
    lineNames: found.map(({name}) => name),
  };
}

/** The material of an outline, by its class or that of its cut line. */
const materialOf = (outline: XmlElement, drawn: readonly Drawn[]): string =>
  [outline, ...drawn.map(({element}) => element).filter((one) => hasClass(one, 'sa'))].flatMap(
    (element) => materials.filter((name) => hasClass(element, name)),
  )[0] ?? 'fabric';
