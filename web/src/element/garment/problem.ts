/** What the element asks the solver: exactly what the stored design stands for, so that the answer can be had again. */
import {printOf, type Design} from '../../model/design.js';
import {SolverError} from '../../model/failure.js';
import type {Problem} from '../../model/problem.js';
import {
  changesOf,
  designOf,
  printOfStored,
  problemOfStored,
  type StoredDesign,
  type StoredProblem,
} from '../../model/stored-design.js';
import type {SolveResult} from '../../model/result.js';
import type {FileWords} from './files.js';

/** What a design does not say by itself. */
export interface Terms {
  /** What holds while the design asks for no symmetry, and nobody has taken the last one away. */
  readonly symmetry: 'auto' | 'none';
  /** The design's symmetries as they were given. */
  readonly given: Design['symmetries'];
  readonly seed: number;
}

/** What to solve in place of a list of symmetries that is empty. */
export const unasked = ({symmetries}: Design, {symmetry, given}: Terms): 'auto' | 'none' =>
  symmetries === given ? symmetry : 'none';

/** For what has no place: it can be solved all the same. */
const nowhere = {url: 'print', sha256: ''};

function storedProblem(design: Design, terms: Terms): StoredProblem {
  const {garment, print, symmetries, method, options} = design;
  const {text = '', place = nowhere, colourway} = print.file ?? {};
  const worn = {...place, ...(colourway !== undefined && {colourway})};
  const file = printOfStored({print: worn}, text);
  return {
    garment: garment.file ?? nowhere,
    print: {...worn, ...changesOf(print, file)},
    symmetry: symmetries.length > 0 ? symmetries : unasked(design, terms),
    method,
    options,
    seed: terms.seed,
  };
}

export function problemFor(design: Design, terms: Terms): Problem {
  const {garment, print, symmetries, method, options} = design;
  if (print.file) {
    const texts = {garment: garment.text, print: print.file.text};
    return problemOfStored(storedProblem(design, terms), texts);
  }
  // somebody has opened a picture of their own
  return {
    garment: garment.text,
    print: printOf(print),
    symmetry: symmetries.length > 0 ? {symmetries} : unasked(design, terms),
    method,
    options,
    seed: terms.seed,
  };
}

/** @throws {SolverError} with one sentence when garment or print have no place that could be stored */
export function storedDesign(
  design: Design,
  result: SolveResult,
  terms: Terms,
  words: FileWords,
): StoredDesign {
  const missing = !design.garment.file
    ? words.garment
    : !design.print.file?.place
      ? words.print
      : undefined;
  if (missing !== undefined) {
    throw new SolverError({code: 'options', message: words.notStorable(missing)});
  }
  return designOf(storedProblem(design, terms), result);
}
