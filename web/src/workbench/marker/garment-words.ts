/** Names of the garments on a fabric, and of their pieces. */
import {decidedOf, type DesignGarment} from '../../model/design/design.js';
import {garmentTitle, panelMarks} from '../../model/garment/panel-marks.js';
import {readable, titleOfFile} from '../../model/garment/piece-names.js';
import {withSampleNames} from '../../texts/sample-names.js';
import type {Texts} from '../../texts/texts.js';
import type {Samples} from '../samples.js';
import type {SolvedGarment} from './added-results.js';

/** The letter of a garment: A for the design's own, then B and so on. */
export const letterOf = (which: number): string => String.fromCharCode(65 + (which % 26));

/**
 * "Tee, M"; the name of the file for a garment that is no sample.
 * @param known the samples, once they are loaded
 */
export function garmentName(
  {name, sample}: Pick<DesignGarment, 'name' | 'sample'>,
  {samples}: Texts,
  known?: Samples,
): string {
  if (!sample) return titleOfFile(name);
  const {style, size} = sample;
  const {title = readable(style)} = known?.garments.find((one) => one.style === style) ?? {};
  return `${samples.garments[style] ?? title}, ${size.toUpperCase()}`;
}

/** Title and size of a solved garment, as on its cutting sheet. */
export function titleOf({design, document}: SolvedGarment, texts: Texts): string {
  const {name} = design.garment;
  const {title = titleOfFile(name), size} = garmentTitle(
    withSampleNames(document, name, texts),
    name,
  );
  return size === undefined ? title : `${title}, ${size}`;
}

const known = new WeakMap<
  SolvedGarment,
  {readonly texts: Texts; readonly labels: ReadonlyMap<string, string>}
>();

/** The label of a piece of a solved garment. */
export function pieceLabel(garment: SolvedGarment, piece: string, texts: Texts): string {
  const before = known.get(garment);
  const labels = before?.texts === texts ? before.labels : labelsOf(garment, texts);
  if (labels !== before?.labels) known.set(garment, {texts, labels});
  return labels.get(piece) ?? readable(piece);
}

function labelsOf({design, document}: SolvedGarment, texts: Texts): ReadonlyMap<string, string> {
  const named = withSampleNames(document, design.garment.name, texts);
  return new Map([...panelMarks(named, decidedOf(design))].map(([name, {label}]) => [name, label]));
}
