/** Applies a remedy as one step of the history. */
import type {Design, DesignPrint} from '../../model/design.js';
import {repeatOf} from '../../model/repeat.js';
import {printOf} from '../../model/design.js';
import type {Remedy} from '../../remedies/remedy.js';
import {sampleOf} from '../print/choices.js';
import {samplePrint, type Samples} from '../../workbench/samples.js';

/**
 * Returns the change of the design. It is undefined if the remedy needs a print that is not
 * available, since the print of the design has no such mirrors.
 */
export function remedied(
  {options, print}: Design,
  {change}: Remedy,
  samples: Samples | undefined,
): Partial<Design> | undefined {
  if (change.options) return {options: {...options, ...change.options}};
  const {group} = change.print ?? {};
  if (group === undefined) return {print: half(print)};
  const sample = samples?.prints.find(({name}) => name === sampleOf(group));
  if (!sample) return undefined;
  const {w1, w2} = printOf(print);
  return {print: {...samplePrint(sample), ...repeatOf({group, w1, w2})}};
}

const half = (print: DesignPrint): DesignPrint => {
  const {width, height} = print.size;
  return {...print, size: {...print.size, width: width / 2, height: height / 2}};
};
