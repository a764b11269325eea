/**
 * Lines of pleats, tucks and creases among the lines drawn on a piece, recognised by the text
 * beside them.
 */
import {countOf, saysFold} from './words.js';
import {nearestOn} from '../../model/geometry/nearest.js';
import type {DraftedFold, FoldKind} from '../../model/garment/garment-document.js';
import {hidesFabric} from '../../model/garment/folds.js';
import {linesInside} from '../../model/geometry/polyline.js';
import {
  cross,
  distance,
  dot,
  middle,
  minus,
  unit,
  type Point,
} from '../../model/geometry/vectors.js';

type Line = readonly Point[];

/** Text, and its place in the coordinates of the lines. */
interface Label {
  readonly at: Point;
  readonly text: string;
}

/** Text of files of Seamwise, see `foldText`. */
const ownText = /^(knife|box|inverted|tuck|roll|press) fold (\d+)( to)?$/i;

/** Words for kinds of folds in five languages; the first that matches counts. */
const kindWords: readonly (readonly [FoldKind, RegExp])[] = [
  ['roll', /roll(?:ing)? line|umbruch(?:linie|kante)|ligne de (?:roulure|cassure)|l[ií]nea de quiebre|linea di rovescio/i],
  ['press', /fold here|hier falten|plier ici|dobl(?:ar|a|ad) aqu[ií]|piega(?:re)? qui/i],
  ['press', /press(?:ing)? line|crease|bügelfalte|pli (?:marqué|repassé)|raya del pantalón|l[ií]nea de planchado|piega stirata/i],
  ['inverted', /inverted pleat|kellerfalte|pli creux|(?:pliegue|tabla) invertid[oa]|piega (?:invertita|a soffietto)|sfondo ?piega/i],
  ['box', /box[- ]?pleat|quetschfalte|pli (?:plat double|rond)|pliegue (?:de )?(?:caja|tabla)|tablón|cannone/i],
  ['tuck', /\btucks?\b|\bbiesen?\b|nervures?|alforzas?|jaretas?|nervatur[ae]/i],
  ['knife', /pleat|\bfalten?\b|messerfalte|pli (?:couché|plat)|pliegues?\b|\bpiegh?[ae]\b/i],
]; // prettier-ignore

/** Greatest distance of text from its line, and of text from the line of its own file. [cm] */
const besideLine = 2;
const onLine = 0.1;
/** Lines this close to the connection of the lines of a pleat are its arrow. [cm] */
const arrowWidth = 0.5;
/** Greatest deviation from the distance that a text states. [cm] */
const statedReach = 0.3;
/** Greatest distance of two lines between which a text stands, and least ratio of their lengths. [cm] */
const widestBetween = 15;
const leastAlike = 0.6;
/** Greatest distance of the ends of an arrow from the lines that it joins. [cm] */
const arrowReach = 0.6;
/** Greatest width of an arrowhead, as a share of the shaft. */
const headShare = 0.75;
/** Deviation of a straight line as a share of its length, and of two parallel ones. [rad] */
const straight = 1e-3;
const parallel = 0.02;
/** Distance between the lines of a pleat. [cm] */
const narrowest = 0.2;
const widest = 40;

interface Labelled {
  /** Place of the text. */
  readonly at: Point;
  readonly line: Line;
  readonly kind: FoldKind;
  /** Distance between the lines that the text states. [cm] */
  readonly widthCm?: number;
  /** Number of the fold in a file of Seamwise, and true for its second line. */
  readonly own?: {readonly number: string; readonly isSecond: boolean};
}

/** The kind that a text names; undefined for other text, such as that of a half piece. */
function kindOf(text: string): FoldKind | undefined {
  if (text.length > 60 || saysFold([text]) || countOf([text])) return undefined;
  return kindWords.find(([, words]) => words.test(text))?.[0];
}

/** The farthest point of a line from a given one. */
const farthest = (line: Line, from: Point): Point =>
  line.reduce((best, p) => (distance(p, from) > distance(best, from) ? p : best), from);

/** The ends of a straight line; one that is drawn in pieces may go to and fro. */
function endsOf(line: Line): readonly [Point, Point] {
  const [start = [0, 0]] = line;
  const to = farthest(line, start);
  const from = farthest(line, to);
  return from === start || distance(from, start) < distance(to, start) ? [from, to] : [to, from];
}

function isStraight(line: Line): boolean {
  const [from, to] = endsOf(line);
  const length = distance(from, to);
  const along = unit(minus(to, from));
  return (
    length > 0 && line.every((p) => Math.abs(cross(along, minus(p, from))) < straight * length)
  );
}

const unitsCm: Readonly<Record<string, number>> = {mm: 0.1, cm: 1, in: 2.54, '"': 2.54, '″': 2.54};

/** The length in a text such as "Tuck, 9 cm". */
function widthIn(text: string): number | undefined {
  const [, value, unitName = ''] = /(\d+(?:[.,]\d+)?)\s*(mm|cm|in\b|"|″)/.exec(text) ?? [];
  const cm = unitsCm[unitName];
  return value === undefined || cm === undefined ? undefined : cm * Number(value.replace(',', '.'));
}

function labelled(lines: readonly Line[], {at, text}: Label, cmPerUnit: number): Labelled[] {
  const own = ownText.exec(text.trim());
  const kind = own ? (own[1]?.toLowerCase() as FoldKind) : kindOf(text);
  if (kind === undefined) return [];
  const off = (line: Line): number =>
    cmPerUnit * (own ? distance(middle(...endsOf(line)), at) : nearestOn(line, at, false).off);
  const [line] = lines.filter(isStraight).sort((a, b) => off(a) - off(b));
  if (!line || off(line) > (own ? onLine : besideLine)) return [];
  const [, , number = '', second] = own ?? [];
  const widthCm = widthIn(text);
  return [
    {
      ...{at, line, kind},
      ...(widthCm !== undefined && {widthCm}),
      ...(own && {own: {number, isSecond: second !== undefined}}),
    },
  ];
}

/** Returns whether a line is drawn twice, such as a halo beneath another line. */
function isSame(one: Line, other: Line, cmPerUnit: number): boolean {
  const [[a, b], [c, d]] = [endsOf(one), endsOf(other)];
  const off = (p: Point, q: Point): number => cmPerUnit * distance(p, q);
  return Math.min(Math.max(off(a, c), off(b, d)), Math.max(off(a, d), off(b, c))) < onLine;
}

/** Distance between two parallel lines beside each other; undefined for others. [cm] */
function apart(one: Line, other: Line, cmPerUnit: number): number | undefined {
  const [[a, b], [c, d]] = [endsOf(one), endsOf(other)];
  const [along, beside] = [unit(minus(b, a)), unit(minus(d, c))];
  const across = minus(middle(c, d), middle(a, b));
  const off = cmPerUnit * Math.abs(cross(along, across));
  const isBeside = Math.abs(dot(along, across)) < Math.min(distance(a, b), distance(c, d)) / 2;
  const isParallel = Math.abs(cross(along, beside)) < parallel;
  return isBeside && isParallel && off > narrowest && off < widest ? off : undefined;
}

/**
 * The other line of a pleat: at the distance that the text states, otherwise the nearest one with
 * the same text.
 */
function partnerOf(
  one: Labelled,
  all: readonly Labelled[],
  lines: readonly Line[],
  cmPerUnit: number,
): Line | undefined {
  const {widthCm} = one;
  const candidates =
    widthCm === undefined || one.own
      ? all
          .filter(({kind, own}) => kind === one.kind && own?.number === one.own?.number)
          .map(({line}) => line)
      : lines.filter(isStraight);
  const miss = (line: Line): number => {
    const off = apart(one.line, line, cmPerUnit);
    if (off === undefined) return Infinity;
    return widthCm === undefined ? off : Math.abs(off - widthCm);
  };
  const [best] = candidates
    .filter((line) => miss(line) < (widthCm === undefined ? widest : statedReach))
    .sort((a, b) => miss(a) - miss(b));
  return best;
}

/**
 * The other line of a pleat whose text stands between its lines, or whose arrow joins them: the
 * nearest parallel one on the other side of the text.
 */
function acrossText(
  {at, line}: Labelled,
  lines: readonly Line[],
  cmPerUnit: number,
): Line | undefined {
  const [from, to] = endsOf(line);
  const along = unit(minus(to, from));
  const sideOf = (p: Point): number => cross(along, minus(p, from));
  const offOf = (one: Line): number => apart(line, one, cmPerUnit) ?? Infinity;
  const [nearest] = lines
    .filter((one) => {
      if (one === line || !isStraight(one) || offOf(one) > widestBetween) return false;
      const ratio = distance(...endsOf(one)) / distance(from, to);
      return Math.min(ratio, 1 / ratio) > leastAlike;
    })
    .sort((a, b) => offOf(a) - offOf(b));
  if (!nearest) return undefined;
  const middleSide = sideOf(middle(...endsOf(nearest)));
  const isBetween = sideOf(at) / middleSide > 0 && Math.abs(sideOf(at)) < Math.abs(middleSide);
  const isJoined = lines.some((one) => isShaft(one, [line, nearest], cmPerUnit));
  return isBetween || isJoined ? nearest : undefined;
}

/** Returns whether a straight line joins two others, as the shaft of an arrow does. */
function isShaft(shaft: Line, [one, other]: readonly [Line, Line], cmPerUnit: number): boolean {
  if (shaft === one || shaft === other || !isStraight(shaft)) return false;
  const ends = endsOf(shaft);
  const meets = (p: Point, line: Line): boolean =>
    cmPerUnit * nearestOn(line, p, false).off < arrowReach;
  return [ends, [ends[1], ends[0]] as const].some(([p, q]) => meets(p, one) && meets(q, other));
}

/**
 * Returns whether the arrow between two lines points at the first one: its head is drawn there, as
 * short lines that meet at the end of the shaft.
 */
function pointsAtFirst(
  first: Line,
  second: Line,
  lines: readonly Line[],
  cmPerUnit: number,
): boolean {
  const shaft = lines.find((one) => isShaft(one, [first, second], cmPerUnit));
  if (!shaft) return false;
  const ends = endsOf(shaft);
  const heads = (p: Point): number =>
    lines.filter(
      (one) =>
        one !== shaft &&
        one.length <= 4 &&
        distance(...endsOf(one)) < headShare * distance(...ends) &&
        one.some((q) => cmPerUnit * distance(p, q) < onLine),
    ).length;
  const isNear = (p: Point): boolean =>
    nearestOn(first, p, false).off < nearestOn(second, p, false).off;
  const [near, far] = isNear(ends[0]) ? ends : [ends[1], ends[0]];
  return heads(near) > heads(far);
}

/** The fold of a line and the one on which it is laid, in the same direction. */
function foldOf({kind, line}: Labelled, second: Line | undefined): DraftedFold {
  const ends = endsOf(line);
  if (!second) return {kind, line: ends};
  const [from, to] = endsOf(second);
  const isReversed = dot(minus(ends[1], ends[0]), minus(to, from)) < 0;
  return {kind, line: ends, to: isReversed ? [to, from] : [from, to]};
}

/**
 * The folds among lines, and the other lines. Two labelled lines of one kind beside each other are
 * a pleat, laid from the first onto the second, as are two lines with one text between them or with
 * an arrow from one to the other. A labelled line alone is a crease, or stays a line.
 * @param cmPerUnit of the lines
 */
export function foldsAmong(
  lines: readonly Line[],
  labels: readonly Label[],
  cmPerUnit: number,
): {readonly folds: readonly DraftedFold[]; readonly lines: readonly Line[]} {
  const all = labels
    .flatMap((label) => labelled(lines, label, cmPerUnit))
    .filter(
      ({line}, k, every) => every.findIndex((one) => isSame(one.line, line, cmPerUnit)) === k,
    );
  const used = new Set<Line>();
  const isUsed = (line: Line): boolean => [...used].some((one) => isSame(one, line, cmPerUnit));
  const folds = all.flatMap((one): DraftedFold[] => {
    if (isUsed(one.line) || one.own?.isSecond) return [];
    const free = lines.filter((line) => !isUsed(line));
    const isCrease = !hidesFabric(one);
    const second =
      partnerOf(
        one,
        all.filter(({line}) => !used.has(line)),
        free,
        cmPerUnit,
      ) ?? (isCrease || one.own ? undefined : acrossText(one, free, cmPerUnit));
    const isAlone = isCrease && !one.own;
    if (!second && !isCrease) return [];
    used.add(one.line);
    if (second && !isAlone) used.add(second);
    const isTurned =
      second !== undefined && !one.own && pointsAtFirst(one.line, second, lines, cmPerUnit);
    return [
      isTurned
        ? foldOf({...one, line: second}, one.line)
        : foldOf(one, isAlone ? undefined : second),
    ];
  });
  const isArrow = (line: Line): boolean =>
    folds.some(({line: first, to}) => {
      const shaft = to ? [middle(...first), middle(...to)] : [];
      return line.every((p) => cmPerUnit * nearestOn(shaft, p, false).off < arrowWidth);
    });
  return {folds, lines: lines.filter((line) => !isUsed(line) && !isArrow(line))};
}

/** Folds whose lines end at the sewn outline, not in the allowance beyond it. */
export function foldsWithin(folds: readonly DraftedFold[], outline: Line): readonly DraftedFold[] {
  const within = (ends: readonly [Point, Point]): readonly [Point, Point] => {
    const [longest] = [...linesInside([outline], ...ends)].sort(
      (a, b) => distance(...b) - distance(...a),
    );
    return longest ?? ends;
  };
  return folds.map((fold) => ({
    ...fold,
    line: within(fold.line),
    ...(fold.to && {to: within(fold.to)}),
  }));
}
