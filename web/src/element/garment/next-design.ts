/** The design that follows when something else is asked for: what the user has changed of the rest stays. */
import type {Design} from '../../model/design.js';
import {fieldOf} from '../../model/read.js';
import {newDesign} from '../../workbench/samples.js';
import type {Asked, Loaded} from './sources.js';

/** What was asked for, and what came of it. */
export interface Answered {
  readonly asked: Asked;
  readonly loaded: Loaded;
}

type Pins = Design['options']['pins'];

/** @param before undefined to begin anew; `now` is what has become of it */
export function nextDesign(
  {asked, loaded}: Answered,
  before: Answered | undefined,
  now: Design | undefined,
): Design {
  const {garment, print} = loaded;
  const fresh = newDesign(garment, print);
  const isSameGarment = before?.loaded.garment === garment;
  const kept = now && before ? now : fresh;
  const {pins, ...options} = isSameGarment || !before ? kept.options : fresh.options;
  const isSameMost = before?.asked.maxChangeCm === asked.maxChangeCm;
  const most = isSameMost ? kept.options.maxChangeCm : asked.maxChangeCm;
  const placed =
    pins ??
    (before && !isSameGarment ? pinsFor({asked, loaded}, before, kept.options.pins) : undefined);
  const isSameSymmetry = isSameGarment && before.asked.symmetry === asked.symmetry;
  return {
    garment,
    print: before?.loaded.print === print ? kept.print : print,
    symmetry: isSameSymmetry && now ? now.symmetry : loaded.symmetry,
    method: kept.method,
    options: {
      ...options,
      ...(most !== undefined && {maxChangeCm: most}),
      ...(placed && {pins: placed}),
    },
    seed: kept.seed,
    ...(isSameGarment && kept.names && {names: kept.names}),
  };
}

/**
 * What was put on the pieces of one size stays on those of another. Another pattern may have pieces of the same names,
 * which say nothing of where a customer wants its print.
 */
function pinsFor(next: Answered, before: Answered, pins: Pins): Pins {
  const file = contentOf(next);
  if (!pins || !isOtherSize(next, before, file)) return undefined;
  const panels = fieldOf(fieldOf(file, 'pattern'), 'panels');
  const names = typeof panels === 'object' && panels !== null ? Object.keys(panels) : [];
  const kept = Object.entries(pins).filter(([name]) => names.includes(name));
  return kept.length > 0 ? Object.fromEntries(kept) : undefined;
}

/** By the same template, or as both files say by their title. */
function isOtherSize(next: Answered, before: Answered, file: unknown): boolean {
  if (typeof next.asked.garment === 'string' && next.asked.garment === before.asked.garment) {
    return true;
  }
  const title = fieldOf(file, 'title');
  return typeof title === 'string' && title === fieldOf(contentOf(before), 'title');
}

/** Whatever is in the file: the solver says what is wrong with it. */
function contentOf({loaded}: Answered): unknown {
  try {
    return JSON.parse(loaded.garment.text);
  } catch {
    return undefined;
  }
}
