/** The design that follows when something else is asked for: what the user has changed of the rest stays. */
import type {Design} from '../../model/design.js';
import {newDesign} from '../workbench/samples.js';
import type {Asked, Loaded} from './sources.js';

/** What was asked for, and what came of it. */
export interface Answered {
  readonly asked: Asked;
  readonly loaded: Loaded;
}

/** @param before undefined to begin anew; `now` is what has become of it */
export function nextDesign(
  {asked, loaded}: Answered,
  before: Answered | undefined,
  now: Design | undefined,
): Design {
  const {garment, print, symmetries} = loaded;
  const fresh = newDesign(garment, print);
  const isSameGarment = before?.loaded.garment === garment;
  const kept = now && before ? now : fresh;
  const {pins, ...options} = isSameGarment || !before ? kept.options : fresh.options;
  const isSameMost = before?.asked.maxChangeCm === asked.maxChangeCm;
  const most = isSameMost ? kept.options.maxChangeCm : asked.maxChangeCm;
  const placed = pins ?? pinsFor(garment.text, kept.options.pins);
  const isSameSymmetry = isSameGarment && before.asked.symmetry === asked.symmetry;
  return {
    garment,
    print: before?.loaded.print === print ? kept.print : print,
    symmetries: isSameSymmetry ? kept.symmetries : symmetries,
    method: kept.method,
    options: {
      ...options,
      ...(most !== undefined && {maxChangeCm: most}),
      ...(placed && {pins: placed}),
    },
  };
}

/** Of the pieces that another size of a garment still has, the prints stay where they were put. */
function pinsFor(
  text: string,
  pins: Design['options']['pins'],
): Design['options']['pins'] | undefined {
  if (!pins) return undefined;
  const kept = Object.entries(pins).filter(([name]) => text.includes(JSON.stringify(name)));
  return kept.length > 0 ? Object.fromEntries(kept) : undefined;
}
