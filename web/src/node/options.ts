/** Options and hooks of functions of `seamwise/node`. */
import type {PieceDxfOptions} from '../cutting/out/piece-dxf.js';
import type {Remedy} from '../remedies/remedy.js';
import type {NamedPrepareHooks} from '../solver/requests/requests.js';

export interface RemedyHooks extends NamedPrepareHooks {
  /** Called as soon as a remedy is found. */
  readonly onRemedy?: (remedy: Remedy) => void;
}

export interface ConvertOptions {
  /** Name of the garment in messages. */
  readonly name?: string;
  /** Writes a plain GarmentCode specification; see `convert`. */
  readonly plain?: boolean;
  /**
   * Divides edges that run across pleats, so that seams count the length of pleated edges with the
   * pleats closed. The numbers of edges and stitches change.
   */
  readonly dividePleats?: boolean;
}

export interface GarmentDxfOptions extends PieceDxfOptions {
  /** Name of the garment in messages, and its title if it has none. */
  readonly name?: string;
  /** Allowance of edges without their own. Default 0. [cm] */
  readonly allowanceCm?: number;
}
