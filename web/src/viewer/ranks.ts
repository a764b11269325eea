/**
 * Ranks of the seams with the greatest mismatch: small discs beside them, or at the end of a thin
 * line if there is no room.
 */
import {angleOf, plus, type Point} from '../model/geometry/vectors.js';
import type {SeamSide} from '../model/result/result.js';
import {chipColours, chipLayer, move, overlap, placeable, type Box} from './chips.js';
import {outsideOf} from './outside.js';
import {lineOf, type PatternScene, type SceneSeam} from '../scene/scene.js';
import {atShare, boxOf, isInside, type OnLine} from '../model/geometry/polyline.js';
import {toScreen, toSheet, type ScreenSize, type SheetView} from '../scene/sheet-view.js';
import {placed, type Appearance} from './strokes.js';

/** Greatest number of ranks, and the least mean mismatch of a ranked seam. */
const mostRanks = 3;
const leastMean = 0.1; // cm
/** Diameter of a disc. [CSS px] */
const rankSize = 18;
/**
 * Distances from the edge to the middle of the disc, the nearest first: clear of the line along the
 * edge. [CSS px]
 */
const reaches = [15, 20, 28, 40, 54];
/** Greatest distance without a line to the seam. [CSS px] */
const nearReach = 20;
/** Places along a side, tried after its greatest mismatch, from 0 to 1. */
const shares = [0.5, 0.35, 0.65, 0.2, 0.8];

/** A place on an edge, and the unit vector out of the piece. */
export interface Anchor {
  readonly at: Point;
  readonly out: Point;
}

/** A free place on the screen. */
interface Spot extends Anchor {
  /** Distance from the edge to the middle of the disc. [CSS px] */
  readonly reach: number;
  readonly box: Box;
}

const isWithin = ({left, top, right, bottom}: Box, {width, height}: ScreenSize): boolean =>
  left >= 0 && top >= 0 && right <= width && bottom <= height;

const squareAt = ([x, y]: Point, side: number): Box => ({
  left: x - side / 2,
  top: y - side / 2,
  right: x + side / 2,
  bottom: y + side / 2,
});

/**
 * Returns the nearest place for a rank that is free, as is the line that leads there. Places off
 * the fabric come first, then those inside the seam. The first anchors are the best. All points are
 * on the screen, y down. [CSS px]
 */
export function spotFor(
  anchors: readonly Anchor[],
  size: ScreenSize,
  taken: readonly Box[],
  isOnFabric: (at: Point) => boolean,
): Spot | undefined {
  const freeOf = (some: readonly Anchor[], how: readonly number[]): readonly Spot[] =>
    how.flatMap((reach) =>
      some.flatMap(({at, out}): Spot[] => {
        const along = (way: number): Point => plus(at, out, way);
        const box = squareAt(along(reach), rankSize);
        const line = reach > nearReach ? ways(reach).map((way) => squareAt(along(way), 2)) : [];
        const isTaken = [box, ...line].some((one) => taken.some((other) => overlap(other, one)));
        return isTaken || !isWithin(box, size) ? [] : [{at, out, reach, box}];
      }),
    );
  const free = freeOf(anchors, reaches);
  const isOff = ({left, top, right, bottom}: Box): boolean => {
    const [x, y] = [(left + right) / 2, (top + bottom) / 2];
    const touched: Point[] = [
      [x, y],
      [left, y],
      [right, y],
      [x, top],
      [x, bottom],
    ];
    return !touched.some(isOnFabric);
  };
  const inwards = anchors.map(({at, out: [x, y]}): Anchor => ({at, out: [-x, -y]}));
  return free.find(({box}) => isOff(box)) ?? freeOf(inwards, reaches.slice(0, 1))[0] ?? free[0];
}

/** Returns distances along the line that leads to a disc. [CSS px] */
const ways = (reach: number): readonly number[] =>
  Array.from({length: Math.floor(reach / 4)}, (_, k) => 4 * k);

interface Rank {
  readonly element: HTMLElement;
  readonly leader: HTMLElement;
  /** Anchors on the sheet, y up. */
  readonly anchors: readonly Anchor[];
}

/** Outline of a piece on the sheet, with its bounding box. */
interface Outline {
  readonly loop: readonly Point[];
  readonly low: Point;
  readonly high: Point;
}

const outlineOf = (loop: readonly Point[]): Outline => ({loop, ...boxOf(loop)});

export class Ranks {
  readonly element = chipLayer();
  #ranks: readonly Rank[] = [];
  #outlines: readonly Outline[] = [];

  /** Shows the ranks of a scene; call again after alignments change. */
  show(scene: PatternScene, appearance: Appearance): void {
    const worst = scene.seams
      .filter(({counts, mean}) => counts && mean > leastMean)
      .sort((a, b) => b.mean - a.mean)
      .slice(0, mostRanks);
    this.#ranks = worst.map((seam, k) => ({
      ...{element: rankChip(k + 1, appearance), leader: leaderLine(appearance)},
      anchors: anchorsOf(scene, seam),
    }));
    this.#outlines = scene.pieces.map((piece) => outlineOf(placed(piece, piece.outline)));
    this.element.replaceChildren(
      ...this.#ranks.map(({leader}) => leader),
      ...this.#ranks.map(({element}) => element),
    );
  }

  /** Moves the ranks to a view, clear of the `taken` boxes and of each other. */
  place(view: SheetView, size: ScreenSize, taken: readonly Box[]): void {
    const all = [...taken];
    const isOnFabric = (at: Point): boolean => {
      const [x, y] = toSheet(view, size, at);
      return this.#outlines.some(
        ({loop, low, high}) =>
          x > low[0] && x < high[0] && y > low[1] && y < high[1] && isInside(loop, [x, y]),
      );
    };
    for (const {element, leader, anchors} of this.#ranks) {
      const onScreen = anchors.map(({at, out: [x, y]}): Anchor => ({
        at: toScreen(view, size, at),
        out: [x, -y],
      }));
      const spot = spotFor(onScreen, size, all, isOnFabric);
      if (spot) all.push(spot.box);
      move(element, spot && [spot.box.left, spot.box.top]);
      const isFar = spot !== undefined && spot.reach > nearReach;
      move(
        leader,
        isFar ? spot.at : undefined,
        isFar ? `rotate(${angleOf(spot.out).toFixed(3)}rad)` : '',
      );
      if (isFar) leader.style.width = `${spot.reach - rankSize / 2}px`;
    }
  }
}

/** Returns the place of the greatest mismatch on both sides, then places along them. */
function anchorsOf(scene: PatternScene, {a, b, worst}: SceneSeam): readonly Anchor[] {
  const sides = [a, b].map((side) => ({side, line: lineOf(scene, side)}));
  const anchor = ({side}: {readonly side: SeamSide}, {at, along}: OnLine): Anchor => {
    const outside = outsideOf(scene.pieces[side.piece], side.vertices);
    return {at, out: [outside * along[1], -outside * along[0]]};
  };
  return [
    ...sides.flatMap((one) => {
      const edge = one.line.slice(worst.edge, worst.edge + 2);
      return edge.length === 2 ? [anchor(one, atShare(edge, 0.5))] : [];
    }),
    ...shares.flatMap((share) => sides.map((one) => anchor(one, atShare(one.line, share)))),
  ];
}

function leaderLine(appearance: Appearance): HTMLElement {
  return placeable(document.createElement('span'), {
    height: '1.5px',
    marginTop: '-0.75px',
    transformOrigin: '0 50%',
    background: chipColours[appearance].text,
    boxShadow: `0 0 0 1px ${chipColours[appearance].paper}`,
  });
}

function rankChip(rank: number, appearance: Appearance): HTMLElement {
  const {text, paper} = chipColours[appearance];
  const element = placeable(document.createElement('span'), {
    boxSizing: 'border-box',
    width: `${rankSize}px`,
    height: `${rankSize}px`,
    borderRadius: '50%',
    background: text,
    color: paper,
    textAlign: 'center',
    font: `600 11px/${rankSize}px system-ui, sans-serif`,
  });
  element.textContent = String(rank);
  return element;
}
