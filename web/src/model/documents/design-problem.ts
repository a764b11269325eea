/**
 * Builds the solver's problem from a design. It does not depend on the source of garment and print.
 */
import {decisionsOf, printOf, type Decisions, type Design} from '../design/design.js';
import type {Print} from '../print/repeating-print.js';
import type {SingleProblem} from '../design/solve-problem.js';
import {changesOf, printOfStored, printTextOf, type FiledDesign} from './filed-design.js';

/**
 * Problem of these decisions.
 * @param garment text of its file
 * @param print the print as the solver takes it
 */
export const problemFor = (
  {symmetry, method, options, seed}: Decisions,
  garment: string,
  print: Print | string,
): SingleProblem => ({
  garment,
  print,
  symmetry: typeof symmetry === 'string' ? symmetry : {symmetries: symmetry},
  ...{method, options, seed},
});

/**
 * Problem of a design of files, the same wherever it is solved.
 * @param texts contents of the two files
 * @throws {FileError} naming the print's file
 */
export const problemOfStored = (
  design: FiledDesign,
  texts: {readonly garment: string; readonly print: string},
): SingleProblem => problemFor(design, texts.garment, printTextOf(design, texts.print));

/** Placeholder for a garment or print without an address; the design can be solved nevertheless. */
const nowhere = {url: 'print', sha256: ''};

/** The same design with references to its files. @throws {FileError} naming the print's file */
export function filedDesign({garment, print, ...decided}: Design): FiledDesign {
  const {text = '', place = nowhere, colourway} = print.file ?? {};
  const worn = {...place, ...(colourway !== undefined && {colourway})};
  const file = printOfStored({print: worn}, text);
  return {
    garment: garment.file ?? nowhere,
    print: {...worn, ...changesOf(print, file)},
    ...decisionsOf(decided),
  };
}

/** Problem of a design. A print from a file gives exactly the problem of its stored design. */
export const problemOf = (design: Design): SingleProblem => {
  const {garment, print} = design;
  return print.file
    ? problemOfStored(filedDesign(design), {garment: garment.text, print: print.file.text})
    : problemFor(design, garment.text, printOf(print));
};
