/** Levels of the test run: a commit checks a sample of the cases, the thorough run all of them. */

/** Set by `npm test -- thorough`. */
export const isThorough = process.env.SEAMWISE_TESTS === 'thorough';

/** The number of cases to try. @param few  for a commit @param all  in the thorough run */
export const cases = (few: number, all: number): number => (isThorough ? all : few);

/** The cases themselves. @param few  number of the first ones that a commit tries */
export const sampleOf = <T>(few: number, all: readonly T[]): readonly T[] =>
  isThorough ? all : all.slice(0, few);
