/** Decisions as the page's files write them: projects, links, results, and what a browser keeps of a history. */
import {askingFor, usualSeed, type AskedSymmetry, type Decisions} from './design.js';

/** What stands in such a file for two of the decisions. */
interface WrittenFields {
  /** Empty for `none`. */
  readonly symmetries: Exclude<AskedSymmetry, 'none'>;
  /** Left out where it is the usual one. */
  readonly seed?: number;
}

export type Written<D extends Decisions> = Omit<D, 'symmetry' | 'seed'> & WrittenFields;

/** A design, or its decisions alone, to be written. */
export const written = <D extends Decisions>({symmetry, seed, ...others}: D): Written<D> => ({
  ...others,
  symmetries: symmetry === 'none' ? [] : symmetry,
  ...(seed !== usualSeed && {seed}),
});

/** What is held of what was written. */
export const heldOf = <W extends Partial<WrittenFields>>({
  symmetries = [],
  seed = usualSeed,
  ...others
}: W): Omit<W, 'symmetries' | 'seed'> & Pick<Decisions, 'symmetry' | 'seed'> => ({
  ...others,
  symmetry: typeof symmetries === 'string' ? symmetries : askingFor(symmetries),
  seed,
});
