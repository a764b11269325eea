/** Rules for the checks of layouts, and their names for pieces. */
import {minus, rotated} from '@/model/geometry/vectors.js';
import type {LaidPlacement} from '@/model/result/marker-plan.js';
import type {ResultPiece, SolveResult} from '@/model/result/result.js';
import type {TurnRule} from './plan-print.js';
import type {Ring} from './rings.js';

/** Settings of a layout that its plan does not contain. */
export interface PlanRules {
  /** Rule by the name of a piece. */
  readonly turns: (piece: string) => TurnRule;
  /** Number of garments of each result. Default 1. */
  readonly copies?: number;
  /** Default none. */
  readonly nap?: 'none' | 'garment' | 'one-way';
  /**
   * 'component' if all pieces that matched seams connect may be shifted on the print together.
   * Default kept.
   */
  readonly shift?: 'kept' | 'component';
  /** Polygons of the fabric that pieces must not cover; the start of the layout is fixed. */
  readonly flaws?: readonly Ring[];
  /** True if the start of the layout is fixed, with or without flaws. Default false. */
  readonly isStartFixed?: boolean;
  /** True if the length is a multiple of the repeat. Default false. */
  readonly wholeRepeats?: boolean;
  /** Pieces, by name, that are not cut from the print. */
  readonly plain?: readonly string[];
  /**
   * True if the garment has its own allowances, so that no single one of the plan applies to all
   * edges. Default false.
   */
  readonly hasOwnAllowances?: boolean;
}

/** A piece of a garment of a result. */
type Named = Pick<LaidPlacement, 'result' | 'copy' | 'piece'>;

export const nameOf = ({result, copy, piece}: Named): string => `${piece} of ${result}.${copy}`;

export const pieceOf = (
  results: readonly SolveResult[],
  result: number,
  name: string,
): ResultPiece | undefined => results[result]?.pieces.find((piece) => piece.name === name);

/** The cut line in the piece's own coordinates. */
export const ringOnPiece = ({cut, angle, translation}: LaidPlacement): Ring =>
  cut.map((p) => rotated(minus(p, translation), -angle));
