/** The garments of a layout, and the length of fabric that each of them takes. Lengths in cm. */
import {signedArea} from '../model/geometry/polyline.js';
import type {GarmentShare, LayPlan} from '../model/result/marker-plan.js';

/** The garments of a layout in the order of its results, with their shares of the length. */
export function garmentShares({
  placements,
  unplaced,
  lengthCm,
}: Pick<LayPlan, 'placements' | 'unplaced' | 'lengthCm'>): readonly GarmentShare[] {
  const all = [...placements, ...unplaced];
  const areaOf = (some: LayPlan['placements']): number =>
    some.reduce((sum, {cut}) => sum + signedArea(cut), 0);
  const whole = areaOf(placements);
  const results = [...new Set(all.map(({result}) => result))].sort((a, b) => a - b);
  return results.map((result): GarmentShare => {
    const own = all.filter((one) => one.result === result);
    const areaCm2 = areaOf(placements.filter((one) => one.result === result));
    return {
      result,
      copies: new Set(own.map(({copy}) => copy)).size,
      pieces: own.length,
      areaCm2,
      lengthCm: whole > 0 ? (lengthCm * areaCm2) / whole : 0,
    };
  });
}

/** The layout of one result's pieces alone, each in its place on the whole fabric. */
export function planOfGarment(plan: LayPlan, which: number): LayPlan {
  const isOwn = ({result}: {readonly result: number}): boolean => result === which;
  const placements = plan.placements.filter(isOwn);
  const area = placements.reduce((sum, {cut}) => sum + signedArea(cut), 0);
  return {
    ...plan,
    placements,
    unplaced: plan.unplaced.filter(isOwn),
    useShare: area / (plan.widthCm * plan.lengthCm || 1),
    ...{boundCm: 0, proven: false, freeLengthCm: null, phases: [], widths: [], cheaper: []},
    garments: (plan.garments ?? garmentShares(plan)).filter(isOwn),
  };
}
