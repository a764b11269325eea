/** A garment to be laid on fabric. */
import type {GarmentDocument} from '../garment/garment-document.js';
import type {PieceNames} from '../garment/piece-names.js';
import type {OtherAlignment, SolveResult} from '../result/result.js';
import type {SolveOptions} from './options.js';
import type {Problem} from './solve-problem.js';

/** A solved garment with its source data. */
export interface MarkerGarment {
  readonly result: SolveResult;
  /** File name, used in messages. */
  readonly name?: string;
  /** Number of garments of this result. Default: the number in the settings of the layout. */
  readonly copies?: number;
  /** Garment file: allowances, grain, and quantity of each piece. */
  readonly garment?: GarmentDocument;
  /** Options of the solve: grain rules, and pieces of plain fabric. */
  readonly options?: Pick<SolveOptions, 'grain' | 'plain'>;
  /** Names chosen for the pieces. */
  readonly names?: PieceNames;
  /** The solved problem, required to solve other designs of the garment. */
  readonly problem?: Problem;
  /** Other designs that match as well. Default: those of the result. */
  readonly others?: readonly OtherAlignment[];
}
