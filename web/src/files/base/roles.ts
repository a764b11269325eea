/**
 * Decides the role of every closed line of a drawing: piece, sewn line, cut-out, mark, frame, title
 * box, grid or test square. Readers state what they know from layers and styles. [mm]
 */
import type {Point} from '../../model/geometry/vectors.js';
import {isInside, signedArea} from '../../model/geometry/polyline.js';
import {
  isCutAround,
  isRectangle,
  isTheSame,
  liesIn,
  overlap,
  type ClosedLine,
  type Words,
} from './closed-lines.js';
import {isFrame, isTitleBox, type Surroundings} from './frames.js';
import {gridCells, isRoundSquare} from './grids.js';

/** A closed line before its role is known. */
export interface Candidate extends ClosedLine {
  /** The role in the file, by its layer or program. */
  readonly stated?: 'piece' | 'sewn line' | 'cut-out' | 'mark';
  /** True if a large line inside another is a piece that lies over it. */
  readonly mayLieOver?: boolean;
  /** True for lines drawn for help only, by their name or a dashed or grey stroke. */
  readonly isAside?: boolean;
  /** Layer or stroke. Cut-outs have that of their outline. */
  readonly style: string;
  /** The path that contains the line. */
  readonly path?: object;
  /** True if the path is filled by the even-odd rule. */
  readonly isEvenOdd?: boolean;
}

export interface RolesOfPiece<T> {
  readonly outline: T;
  readonly sewn?: T;
  readonly cutOuts: readonly T[];
  readonly marks: readonly T[];
  /** The cut-outs that may be lines drawn on the piece. */
  readonly doubtfulCutOuts: readonly T[];
}

export interface Roles<T> {
  /** Pieces in the order of the candidates. */
  readonly pieces: readonly RolesOfPiece<T>[];
  readonly frames: readonly T[];
  readonly titleBoxes: readonly T[];
  /** Lines that repeat others. */
  readonly copies: readonly T[];
  /** Lines outside of all pieces that are too small for one. */
  readonly small: readonly T[];
  /** Cells of grids, and their borders. */
  readonly grids: readonly T[];
  /** Lines that may be pieces: test squares, dashed or grey lines. */
  readonly asides: readonly T[];
  /** Large lines inside pieces that are neither sewn lines nor plausible cut-outs. */
  readonly nested: readonly T[];
}

/** Least area of a piece. [mm2] */
export const leastPiece = 400;

/** Least area of a cut-out that no file states. Smaller lines are marks. [mm2] */
const leastCutOut = 2500;

/** Greatest share of a piece that a cut-out takes. */
const largestCutOut = 0.5;

interface Around {
  readonly words: readonly Words[];
  readonly page?: Point;
  /** Lines that do not close. */
  readonly open?: readonly (readonly Point[])[];
}

export function rolesOf<T extends Candidate>(candidates: readonly T[], around: Around): Roles<T> {
  const sorted = [...candidates].sort((a, b) => b.area - a.area);
  const copies = sorted.filter((line, k) =>
    sorted.slice(Math.max(0, k - 3), k).some((other) => isTheSame(other, line)),
  );
  const single = without(sorted, copies);
  const {grids, asides} = asidesOf(single, around.words);
  const active = without(single, [...grids, ...asides]);
  const {page, words, open = []} = around;
  const unclosed = open.filter((points) => Math.abs(signedArea(points)) >= leastPiece);
  const surroundings: Surroundings<T> = {
    ...(page && {page}),
    // words in an outline that does not close are none of a frame
    words: words.filter(({at}) => !unclosed.some((points) => isInside(points, at))),
    childrenOf: (line) => childrenOf(line, active),
    isRectangle: (line) => isRectangle(line.rim),
  };
  const frames = active.filter((line) => !line.stated && isFrame(line, surroundings));
  const boxes = active.filter((line) => frames.some((one) => isTitleBox(line, one, surroundings)));
  const titleBoxes = active.filter(
    (line) => boxes.includes(line) || boxes.some((box) => liesIn(line, box)),
  );
  const lines = without(active, [...frames, ...titleBoxes]);
  const owners = ownersOf(lines, around.words, isOverlaid(lines));
  const outlines = lines.filter((line) => owners.get(line) === undefined);
  const large = outlines.filter((line) => line.area >= leastPiece && line.stated !== 'mark');
  const nested: T[] = [];
  const pieces = large.map((outline) => {
    const inner = lines.filter((line) => owners.get(line) === outline);
    return rolesIn(outline, inner, nested);
  });
  const order = new Map(candidates.map((line, k) => [line, k]));
  return {
    pieces: pieces.sort((a, b) => (order.get(a.outline) ?? 0) - (order.get(b.outline) ?? 0)),
    ...{frames, titleBoxes, copies, grids, asides, nested},
    small: without(outlines, large),
  };
}

function without<T>(lines: readonly T[], others: readonly T[]): T[] {
  const left = new Set(others);
  return lines.filter((line) => !left.has(line));
}

/** Lines for help, unless nothing else can be a piece. */
function asidesOf<T extends Candidate>(
  lines: readonly T[],
  words: readonly Words[],
): Pick<Roles<T>, 'grids' | 'asides'> {
  const cells = gridCells(lines.filter(({stated}) => !stated));
  const grids = lines.filter(
    (line) => cells.has(line) || (!line.stated && isRectangle(line.rim) && isFullOf(line, cells)),
  );
  const found = without(lines, grids).filter(({stated, isAside}) => !stated && isAside === true);
  const rest = without(lines, [...grids, ...found]);
  const squares = rest.filter(
    (line) =>
      !line.stated &&
      isRoundSquare(line, words) &&
      !rest.some((other) => other !== line && liesIn(line, other)) &&
      rest.some((other) => other.area > 4 * line.area),
  );
  const isPiece = ({area, stated}: T): boolean => area >= leastPiece && stated !== 'mark';
  return rest.some(isPiece) ? {grids, asides: [...found, ...squares]} : {grids: [], asides: []};
}

/** Least number of cells in a grid's border. */
const mostlyCells = 6;

const isFullOf = <T extends Candidate>(line: T, cells: ReadonlySet<T>): boolean =>
  [...cells].filter((cell) => liesIn(cell, line)).length >= mostlyCells;

/** The lines directly inside a line. */
function childrenOf<T extends Candidate>(line: T, lines: readonly T[]): T[] {
  const inner = lines.filter(
    (other) => other !== line && other.area >= leastPiece && liesIn(other, line),
  );
  return inner.filter((one) => !inner.some((other) => other !== one && liesIn(one, other)));
}

/** Returns whether pieces lie over each other, so that no line is a cut-out by its place. */
function isOverlaid(lines: readonly Candidate[]): boolean {
  const large = lines.filter(
    ({mayLieOver, area, stated}) => mayLieOver === true && !stated && area >= leastCutOut,
  );
  return large.some((one, k) => large.slice(k + 1).some((other) => overlap(one, other)));
}

/**
 * The piece that contains each line, among lines that are no pieces by their words.
 * @param lines the largest first
 */
function ownersOf<T extends Candidate>(
  lines: readonly T[],
  words: readonly Words[],
  isDrawnOver: boolean,
): ReadonlyMap<T, T | undefined> {
  const owners = new Map<T, T | undefined>();
  const outlines: T[] = [];
  for (const line of lines) {
    const owner = outlines.findLast((other) => liesIn(line, other));
    const isPiece =
      line.stated === 'piece' ||
      (owner !== undefined && (isOver(line, owner, isDrawnOver) || isNamed(line, owner, words)));
    owners.set(line, isPiece ? undefined : owner);
    const isOutline = isPiece || owner === undefined;
    if (isOutline && line.area >= leastPiece && line.stated !== 'mark') outlines.push(line);
  }
  return owners;
}

/** Returns whether a line is a piece that is drawn over another. */
function isOver(line: Candidate, owner: Candidate, isDrawnOver: boolean): boolean {
  const {mayLieOver, stated, area} = line;
  if (stated || area < leastPiece || mayLieOver !== true) return false;
  const isLarge = area > largestCutOut * owner.area || (isDrawnOver && area >= leastCutOut);
  return isLarge && !isCutAround(owner, line);
}

/** Returns whether a line inside another has its own words, as a piece inside a larger one has. */
function isNamed(line: Candidate, owner: Candidate, words: readonly Words[]): boolean {
  if (line.stated || line.area < leastCutOut || isCutAround(owner, line)) return false;
  const inner = words.filter(({at}) => isInside(line.rim, at));
  const outer = words.filter(({at}) => isInside(owner.rim, at)).length - inner.length;
  return inner.length > 0 && outer > 0 && inner.some(({lines}) => lines.some(isName));
}

/** Returns whether a text can name a piece. */
const isName = (text: string): boolean => /\p{L}{3}/u.test(text);

function rolesIn<T extends Candidate>(
  outline: T,
  inner: readonly T[],
  nested: T[],
): RolesOfPiece<T> {
  const sewn =
    inner.find(({stated}) => stated === 'sewn line') ??
    inner.find((line) => (line.stated ?? 'mark') === 'mark' && isCutAround(outline, line));
  const cutOuts: T[] = [];
  const doubtful: T[] = [];
  const marks: T[] = [];
  for (const line of inner) {
    if (line === sewn) continue;
    const isInCutOut = cutOuts.some((other) => liesIn(line, other));
    if (line.stated === 'cut-out' || (!isInCutOut && isHoleOf(outline, line))) cutOuts.push(line);
    else if (line.stated || sewn || isInCutOut || line.area < leastCutOut) marks.push(line);
    else if (line.area > largestCutOut * outline.area) nested.push(line);
    else if (line.style === outline.style) doubtful.push(line);
    else marks.push(line);
  }
  return {
    outline,
    ...(sewn && {sewn}),
    cutOuts: [...cutOuts, ...doubtful],
    ...{marks, doubtfulCutOuts: doubtful},
  };
}

/** Returns whether a line is a hole of a path by its fill rule. */
const isHoleOf = (outline: Candidate, {path, isEvenOdd, rim}: Candidate): boolean =>
  path !== undefined &&
  path === outline.path &&
  (isEvenOdd === true || signedArea(rim) * signedArea(outline.rim) < 0);
