/** What the solver is asked for a design: the same, wherever garment and print come from. */
import {decisionsOf, printOf, type Decisions, type Design} from './design.js';
import type {Print} from './print.js';
import type {Problem} from './problem.js';
import {changesOf, printOfStored, printTextOf, type FiledDesign} from './stored-design.js';

/** @param garment its file's text @param print as the solver takes it */
export const problemFor = (
  {symmetry, method, options, seed}: Decisions,
  garment: string,
  print: Print | string,
): Problem => ({
  garment,
  print,
  symmetry: typeof symmetry === 'string' ? symmetry : {symmetries: symmetry},
  ...{method, options, seed},
});

/**
 * The one problem that a design of files stands for, wherever it is solved.
 * @param texts of the two files @throws {FileError} naming the print's file
 */
export const problemOfStored = (
  design: FiledDesign,
  texts: {readonly garment: string; readonly print: string},
): Problem => problemFor(design, texts.garment, printTextOf(design, texts.print));

/** For what has no place: it can be solved all the same. */
const nowhere = {url: 'print', sha256: ''};

/** The same design by the files that it was made of. @throws {FileError} naming the print's file */
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

/** Of a print that came from a file it is exactly what its stored design stands for. */
export const problemOf = (design: Design): Problem => {
  const {garment, print} = design;
  return print.file
    ? problemOfStored(filedDesign(design), {garment: garment.text, print: print.file.text})
    : problemFor(design, garment.text, printOf(print));
};
