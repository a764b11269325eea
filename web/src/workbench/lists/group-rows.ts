/** The seams of a sewist as lines of a list: the most visible first, left and right in one line. */
import {lastOf} from '../../model/base/last-of.js';
import type {Design} from '../../model/design/design.js';
import {isKept, keptParts} from '../../model/design/locks.js';
import type {
  MeshedPattern,
  SeamGroup,
  SeamPlace,
  SeamSide,
  SeamState,
} from '../../model/result/result.js';
import {isVisible, mismatchAlong, visibilityOf} from '../../model/result/seam-groups.js';
import {isGathered} from '../../scene/mismatch.js';
import type {PatternScene} from '../../scene/scene.js';
import type {Texts} from '../../texts/texts.js';
import type {Scenes} from '../scenes.js';
import type {Solving} from '../solving.js';
import {importanceOf, type Importance} from './changed-options.js';
import {commonWords, firstUpper} from './names.js';
import {seamRows, type SeamRow, type Shown} from './rows.js';

export interface GroupRow {
  /** Unique name. */
  readonly name: string;
  readonly place: SeamPlace;
  /** The pieces that it joins, of left and right the words that both have. */
  readonly between: string;
  /** Indices of all its stitches, and of the one with the greatest mismatch. */
  readonly seams: readonly number[];
  readonly worst: number;
  /** Number of seams: 2 for left and right in one line. */
  readonly count: number;
  /** Mean length of a seam. [cm] */
  readonly length: number;
  /** Undefined while the state is not known. */
  readonly state: SeamState | undefined;
  readonly reason: SeamGroup['reason'];
  readonly end: SeamGroup['unmatchedEnd'];
  /** 95 % of the length have at most this mismatch, before and after the solve. [cm] */
  readonly before: number;
  readonly after: number;
  readonly visibility: number;
  /** False for a line that is folded away. */
  readonly isVisible: boolean;
  readonly importance: Importance | undefined;
  /** True if the user can switch matching on. */
  readonly canMatch: boolean;
  /** True if the outlines on both sides stay as drafted. */
  readonly kept: boolean;
}

/** The values of a workbench that are read. */
type ShownGroups = Shown & {readonly solving: Pick<Solving, 'seamGroups' | 'result'>};

/** An unchanged workbench returns the same rows; it returns none before the first result. */
export function groupRows(workbench: ShownGroups, texts: Texts): readonly GroupRow[] {
  const {
    history: {design},
    solving: {pattern, result, seamGroups},
    sheet: {scenes},
  } = workbench;
  if (!design || !pattern || !scenes || seamGroups.length === 0) return [];
  const seams = seamRows(workbench, texts);
  return rowsOf(seamGroups, seams, scenes, pattern, design.options, result !== undefined, texts);
}

const rowsOf = lastOf(
  (
    groups: readonly SeamGroup[],
    seams: readonly SeamRow[],
    {before, now}: Scenes,
    pattern: MeshedPattern,
    options: Design['options'],
    isSolved: boolean,
    texts: Texts,
  ): readonly GroupRow[] => {
    const kept = keptParts(pattern, options.locked);
    // an edit may leave fewer seams than the last result has
    const present = groups.filter((group) => group.seams.some((seam) => seam < seams.length));
    const lines = present.map((group): Line => {
      const rows = group.seams.flatMap((seam) => seams.slice(seam, seam + 1));
      const along = ({seams: all}: PatternScene): number =>
        mismatchAlong(rows.flatMap(({seam, counts}) => (counts ? all.slice(seam, seam + 1) : [])));
      const gathers = areLeftAsGathered(group, now);
      return {
        groups: [group],
        rows,
        side: group.side,
        length: rows.reduce((sum, {length}) => sum + length, 0),
        before: along(before),
        after: along(now),
        visibility: visibilityOf(group, options.weights),
        isVisible: !gathers && isVisible(group, options.weights),
        reason: gathers ? 'gather' : group.reason,
        importance: importanceOf(options, rows),
        kept: group.seams.every((seam) => {
          const {a, b} = pattern.seams[seam] ?? {};
          return [a, b].every((side) => edgesOf(pattern, side).every((part) => isKept(kept, part)));
        }),
      };
    });
    const sorted = paired(lines).toSorted(
      (one, other) =>
        Number(other.isVisible) - Number(one.isVisible) || other.visibility - one.visibility,
    );
    const rows = sorted.map((line) => rowOf(line, isSolved, texts));
    return distinct(rows, texts);
  },
);

/** Greatest number of kinds that the line of folded seams names. */
const mostKinds = 3;

/** "13 others: backs of the armholes, gathers and inside seams"; undefined if all are visible. */
export function foldedWords(rows: readonly GroupRow[], {lists, places}: Texts): string | undefined {
  const hidden = rows.filter((row) => !row.isVisible);
  if (hidden.length === 0) return undefined;
  const kinds = hidden.map(({place, reason}) =>
    reason === 'gather' ? lists.gathers : places[place].many,
  );
  const words = [...new Set(kinds)].slice(0, mostKinds).join(', ');
  return lists.others(
    hidden.reduce((sum, {count}) => sum + count, 0),
    words,
  );
}

/** The line to look at first: the most visible one that does not match. */
export const firstOff = (rows: readonly GroupRow[]): GroupRow | undefined =>
  rows.find(({isVisible, state}) => isVisible && state !== 'matches' && state !== 'choice');

/** The worst seam of the next (1) or previous (-1) line; wraps around at the ends. */
export function nextSeam(
  rows: readonly GroupRow[],
  seam: number | undefined,
  step: 1 | -1,
): number | undefined {
  const at = rows.findIndex(({seams}) => seam !== undefined && seams.includes(seam));
  const next = at < 0 ? (step > 0 ? 0 : -1) : (at + step) % rows.length;
  return rows.at(next)?.worst;
}

/** Edges of the garment file along a side of a seam. */
export function edgesOf(
  {pieces}: Pick<MeshedPattern, 'pieces'>,
  side: SeamSide | undefined,
): readonly {readonly piece: number; readonly edge: number}[] {
  if (!side) return [];
  const {outline = [], edges = []} = pieces[side.piece] ?? {};
  const on = new Set(side.vertices);
  const count = outline.length;
  const numbers = outline.flatMap((vertex, k) =>
    on.has(vertex) && on.has(outline[(k + 1) % count] ?? -1) ? edges.slice(k, k + 1) : [],
  );
  return [...new Set(numbers)].map((edge) => ({piece: side.piece, edge}));
}

/** One or two groups of one line. */
interface Line extends Pick<
  GroupRow,
  'length' | 'before' | 'after' | 'visibility' | 'isVisible' | 'importance' | 'kept' | 'reason'
> {
  readonly groups: readonly SeamGroup[];
  readonly rows: readonly SeamRow[];
  readonly side: SeamGroup['side'];
}

/** Greatest difference in length of left and right. [share] */
const sameLength = 0.03;

/** Puts left and right of the same place into one line if they are alike. */
function paired(lines: readonly Line[]): readonly Line[] {
  const left = [...lines];
  return lines.flatMap((line) => {
    if (!left.includes(line)) return [];
    left.splice(left.indexOf(line), 1);
    const twins = left.filter((other) => isTwin(line, other));
    const gap = (other: Line): number => Math.abs(other.length - line.length);
    const [twin] = twins.toSorted((one, other) => gap(one) - gap(other));
    if (!twin || !isAlike(line, twin)) return [line];
    left.splice(left.indexOf(twin), 1);
    return [together(line, twin)];
  });
}

const isTwin = (one: Line, other: Line): boolean =>
  one.side !== undefined &&
  other.side !== undefined &&
  one.side !== other.side &&
  one.groups[0]?.place === other.groups[0]?.place &&
  one.groups[0]?.visibility === other.groups[0]?.visibility &&
  Math.abs(one.length - other.length) <= sameLength * Math.max(one.length, other.length);

/** Greatest difference of unmatched ends that are told as one. [cm] */
const sameEnd = 1;

function isAlike(one: Line, other: Line): boolean {
  const [{state, reason, unmatchedEnd: end}, second] = [one.groups[0] ?? {}, other.groups[0]];
  return (
    state === second?.state &&
    reason === second?.reason &&
    end?.from === second?.unmatchedEnd?.from &&
    Math.abs((end?.cm ?? 0) - (second?.unmatchedEnd?.cm ?? 0)) <= sameEnd &&
    one.visibility === other.visibility &&
    one.importance === other.importance &&
    one.kept === other.kept
  );
}

function together(one: Line, other: Line): Line {
  const [first, second] = one.after >= other.after ? [one, other] : [other, one];
  return {
    ...first,
    groups: [...first.groups, ...second.groups],
    rows: [...first.rows, ...second.rows],
    side: undefined,
    before: Math.max(one.before, other.before),
  };
}

/** Returns whether seams are left out because sewing gathers them. */
const areLeftAsGathered = ({seams, state}: SeamGroup, {pattern}: PatternScene): boolean =>
  state === 'choice' &&
  pattern.seams.filter((_, seam) => seams.includes(seam)).every((seam) => isGathered(seam));

function rowOf(line: Line, isSolved: boolean, texts: Texts): GroupRow {
  const {groups, rows, side, ...rest} = line;
  const {place = 'other', state, unmatchedEnd: end} = groups[0] ?? {};
  const {lists, places} = texts;
  const between = rows
    .map((row) => row.between ?? row.name)
    .reduce((all, one) => (all === one ? all : commonWords(all, one)));
  const plain = groups.length > 1 ? places[place].many : places[place].one;
  const name = place === 'other' ? (rows[0]?.name ?? plain) : firstUpper(plain);
  const worst = rows.reduce(
    (most, row) => (row.after > most.after ? row : most),
    rows[0] ?? nobody,
  );
  return {
    ...rest,
    ...{place, between, end},
    name: side && place !== 'other' ? lists.onSide[side](name) : name,
    seams: rows.map(({seam}) => seam),
    worst: worst.seam,
    count: groups.length,
    state: isSolved ? state : undefined,
    canMatch: rows.some(({canMatch}) => canMatch),
  };
}

const nobody = {seam: -1, after: 0};

/** Adds the pieces to names that several lines have, and numbers to those that stay equal. */
function distinct(rows: readonly GroupRow[], {lists}: Texts): readonly GroupRow[] {
  const named = withOwn(rows, (row) => `${row.name}: ${row.between}`);
  const met = new Map<string, number>();
  return withOwn(named, ({name}) => {
    const number = (met.get(name) ?? 0) + 1;
    met.set(name, number);
    return lists.numbered(name, number);
  });
}

/** Renames the rows whose name another row has. */
function withOwn(
  rows: readonly GroupRow[],
  rename: (row: GroupRow) => string,
): readonly GroupRow[] {
  const count = new Map<string, number>();
  for (const {name} of rows) count.set(name, (count.get(name) ?? 0) + 1);
  return rows.map((row) => (count.get(row.name) === 1 ? row : {...row, name: rename(row)}));
}
