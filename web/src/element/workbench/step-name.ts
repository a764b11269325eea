/** What a step changed, so that taking it back can say what goes. */
import type {Design} from '../../model/design.js';

export type StepName =
  | 'garment'
  | 'size'
  | 'print'
  | 'colours'
  | 'printSize'
  | 'turn'
  | 'symmetry'
  | 'grain'
  | 'place'
  | 'matching'
  | 'printed'
  | 'method'
  | 'cutting';

type Options = Design['options'];

/** What else there is among the options is how pieces are cut. */
const optionNames: Readonly<Partial<Record<keyof Options, StepName>>> = {
  grain: 'grain',
  pins: 'place',
  weights: 'matching',
  unmatched: 'matching',
  plain: 'printed',
};

const differ = (a: unknown, b: unknown): boolean => JSON.stringify(a) !== JSON.stringify(b);

/** The first in this order of all that differs: another garment begins with other symmetries, too. */
export function stepName(from: Design, to: Design): StepName {
  const [a, b] = [from.garment, to.garment];
  if (a.name !== b.name || a.text !== b.text)
    return a.sample && a.sample.style === b.sample?.style ? 'size' : 'garment';
  const [p, q] = [from.print, to.print];
  if (p.title !== q.title || p.group !== q.group || p.sample?.name !== q.sample?.name)
    return 'print';
  if (p.image !== q.image) return p.sample ? 'colours' : 'print';
  if (differ(p.size, q.size)) return 'printSize';
  if (p.turnDeg !== q.turnDeg) return 'turn';
  if (differ(p, q)) return 'print';
  if (differ(from.symmetries, to.symmetries)) return 'symmetry';
  if (from.method !== to.method) return 'method';
  const keys = Object.keys({...from.options, ...to.options}) as (keyof Options)[];
  const changed = keys.find((key) => differ(from.options[key], to.options[key]));
  return (changed && optionNames[changed]) ?? 'cutting';
}
