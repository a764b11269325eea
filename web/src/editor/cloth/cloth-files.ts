/** What there is to take away of a plan. */
import {layPlanText} from '../../marker/plan.js';
import type {LayPlan} from '../../model/lay-plan.js';
import type {ClothTexts} from '../../texts/cloth-texts.js';

interface ClothFile {
  readonly id: string;
  readonly title: string;
  /** Of its name. */
  readonly ending: string;
  /** @throws {Error} with one sentence */
  readonly make: () => Promise<Blob>;
}

export const clothFiles = (plan: LayPlan, words: ClothTexts): readonly ClothFile[] => [
  {
    ...{id: 'plan', title: words.savePlan, ending: 'layplan.json'},
    make: () => Promise.resolve(new Blob([layPlanText(plan)], {type: 'application/json'})),
  },
];
