/** A remedy as one step of the history, and in words. */
import {printOf, type Design, type DesignPrint} from '../../model/design/design.js';
import {repeatOf} from '../../model/print/repeat.js';
import type {Remedy} from '../../remedies/remedy.js';
import {sampleOf} from '../../print/group-choice.js';
import type {Format} from '../../texts/format.js';
import type {Texts} from '../../texts/texts.js';
import {samplePrint, type Samples} from '../samples.js';
import type {Workbench} from '../workbench.js';

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

/** "Turn Waistband by 90°" */
export function remedyName(
  {kind, pieces}: Remedy,
  {sheet: {scenes}}: Workbench,
  {remedies}: Texts,
): string {
  const labels = new Map(scenes?.now.pieces.map(({name, label}) => [name, label]));
  const names = pieces.map((name) => labels.get(name) ?? name).join(', ');
  return remedies.what[kind](names);
}

/** "Turn Waistband by 90°: 20.5 mm → 0 mm" */
export function remedyWords(
  remedy: Remedy,
  workbench: Workbench,
  texts: Texts,
  format: Format,
): string {
  const {before, after} = remedy;
  const effect = texts.remedies.effect(format.fine(before), format.fine(after));
  return `${remedyName(remedy, workbench, texts)}: ${effect}`;
}
