/** Positions of everything in a cutting file, for programs. Lengths in cm, y up. */
import type {CutSheet} from '../cutting/cut-sheet.js';
import {minus, type Alignment, type Point} from '../model/geometry/vectors.js';
import {testSquares} from './first-page.js';
import type {PageLayout} from './pages.js';

export interface SheetMap {
  readonly format: 'seamwise-cut/1';
  /** Width of the sheet, whose lower left corner is the origin. */
  readonly widthCm: number;
  readonly heightCm: number;
  readonly pages: readonly {
    readonly index: number;
    /** Row number and column letter, as 2A; null for a page outside the sheet. */
    readonly name: string | null;
    readonly widthCm: number;
    readonly heightCm: number;
    /** Position of the page's lower left corner on the sheet. */
    readonly sheet: Point;
    /** The drawn part of the sheet: lower left and upper right corner. */
    readonly window: readonly [Point, Point];
  }[];
  readonly pieces: readonly {
    readonly name: string;
    readonly label: string;
    readonly copy: number;
    /** Transform from piece coordinates to the sheet: p_sheet = R(angle) p + translation. */
    readonly place: Alignment;
    readonly cut: readonly Point[];
    readonly cutHoles: readonly (readonly Point[])[];
    readonly sew: readonly Point[];
    readonly sewHoles: readonly (readonly Point[])[];
    readonly notches: CutSheet['pieces'][number]['notches'];
    readonly grain: readonly [Point, Point];
    readonly matchPoints: CutSheet['pieces'][number]['matchPoints'];
    /** Pleats, tucks and creases; absent without any. */
    readonly folds?: CutSheet['pieces'][number]['folds'];
  }[];
  /** `at` is the lower left corner of the square, relative to its page's lower left corner. */
  readonly squares: readonly {
    readonly page: number;
    readonly at: Point;
    readonly sideCm: number;
  }[];
}

export function sheetMap({widthCm, heightCm, pieces}: CutSheet, layout: PageLayout): SheetMap {
  const {pages, block} = layout;
  const first = pages[0]?.low ?? [0, 0];
  return {
    ...{format: 'seamwise-cut/1', widthCm, heightCm},
    pages: pages.map(({name, low, window}, index) => ({
      ...{index, name: name ?? null, sheet: low, window: [window.low, window.high]},
      ...{widthCm: layout.widthCm, heightCm: layout.heightCm},
    })),
    pieces: pieces.map(({cut, sewn, ...piece}) => {
      const [[outline = [], ...holes], [sew = [], ...sewHoles]] = [cut, sewn];
      const {name, label, copy, place, notches, grain, matchPoints, folds} = piece;
      return {
        ...{name, label, copy, place, notches, grain, matchPoints},
        ...(folds.length > 0 && {folds}),
        ...{cut: outline, cutHoles: holes, sew, sewHoles},
      };
    }),
    squares: testSquares(block).map(({low, side}) => ({
      ...{page: 0, at: minus(low, first), sideCm: side},
    })),
  };
}
