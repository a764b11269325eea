/** What the checks of lay plans are told beside the plan, and how they call pieces. */
import {minus, rotated} from '@/model/geometry.js';
import type {LaidPlacement} from '@/model/lay-plan.js';
import type {ResultPiece, SolveResult} from '@/model/result.js';
import type {TurnRule} from './plan-print.js';
import type {Ring} from './rings.js';

/** What was asked for, as far as the plan does not say it. */
export interface PlanRules {
  /** By the name of a piece. */
  readonly turns: (piece: string) => TurnRule;
  /** How many garments of each result. Default 1. */
  readonly copies?: number;
  /** Default none. */
  readonly nap?: 'none' | 'garment' | 'one-way';
  /** Whether all pieces that matched seams join may lie on the print shifted alike. Default kept. */
  readonly shift?: 'kept' | 'component';
  /** Polygons of the cloth on which nothing lies: the cut is where it is. */
  readonly flaws?: readonly Ring[];
  /** The cut is where it is, flaws or not. Default false. */
  readonly isStartFixed?: boolean;
  /** The length is that of whole repeats. Default false. */
  readonly wholeRepeats?: boolean;
  /** Pieces, by name, that are not cut from the print. */
  readonly plain?: readonly string[];
  /** The garment says allowances of its own, so that the plan's is none that all edges have. Default false. */
  readonly hasOwnAllowances?: boolean;
}

/** Of a garment of a result. */
type Named = Pick<LaidPlacement, 'result' | 'copy' | 'piece'>;

export const nameOf = ({result, copy, piece}: Named): string => `${piece} of ${result}.${copy}`;

export const pieceOf = (
  results: readonly SolveResult[],
  result: number,
  name: string,
): ResultPiece | undefined => results[result]?.pieces.find((piece) => piece.name === name);

/** The cut line where the piece was before it was laid. */
export const ringOnPiece = ({cut, angle, translation}: LaidPlacement): Ring =>
  cut.map((p) => rotated(minus(p, translation), -angle));
