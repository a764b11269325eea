/** Names of the history steps of the fabric layout. */
import type {ClothTexts} from '../../texts/marker-texts.js';
import type {LayStep} from '../../workbench/lay-step.js';

function changeBetween(from: LayStep, to: LayStep): keyof ClothTexts['steps'] {
  if (from.choices !== to.choices) return 'cloth';
  if (from.flaws !== to.flaws) return 'flaw';
  const count = ({places}: LayStep): number => places.filter((one) => one !== undefined).length;
  if (from.plan === to.plan && count(to) < count(from)) return 'remove';
  if (from.pins !== to.pins) return 'pin';
  if (from.plan !== to.plan || from.places === to.places) return 'pack';
  const isTurned = to.places.some((place, k) => place?.angle !== from.places[k]?.angle);
  return isTurned ? 'turn' : 'move';
}

/** Returns undefined if there is no step. */
export const layStepWords = (
  from: LayStep | undefined,
  to: LayStep | undefined,
  {steps}: ClothTexts,
): string | undefined => from && to && steps[changeBetween(from, to)];
