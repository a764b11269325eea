/**
 * Decisions in the form of the page's files: projects, links, results, and the history stored by a
 * browser.
 */
import {askingFor, usualSeed, type AskedSymmetry, type Decisions} from './design.js';

/** Two decisions in the form of such files. */
interface WrittenFields {
  /** An empty list for `none`. */
  readonly symmetries: Exclude<AskedSymmetry, 'none'>;
  /** Omitted if it is the usual seed. */
  readonly seed?: number;
}

export type Written<D extends Decisions> = Omit<D, 'symmetry' | 'seed'> & WrittenFields;

/** Converts a design, or its decisions alone, for writing. */
export const written = <D extends Decisions>({symmetry, seed, ...others}: D): Written<D> => ({
  ...others,
  symmetries: symmetry === 'none' ? [] : symmetry,
  ...(seed !== usualSeed && {seed}),
});

/** Converts written decisions back. */
export const heldOf = <W extends Partial<WrittenFields>>({
  symmetries = [],
  seed = usualSeed,
  ...others
}: W): Omit<W, 'symmetries' | 'seed'> & Pick<Decisions, 'symmetry' | 'seed'> => ({
  ...others,
  symmetry: typeof symmetries === 'string' ? symmetries : askingFor(symmetries),
  seed,
});
