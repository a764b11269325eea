/**
 * `seamwise/vue`: registers `<seamwise-garment>`, and declares its attributes for templates in Vue
 * 3.
 */
export * from './auto.js';

import type {SeamwiseGarmentAttributes} from './jsx.js';
import type {GarmentEvents, SeamwiseGarmentEventMap} from './seamwise-garment.js';

type Listeners = {
  [Type in keyof GarmentEvents as `on${Capitalize<Type>}`]?: (
    event: SeamwiseGarmentEventMap[Type],
  ) => void;
};

declare module 'vue' {
  interface GlobalComponents {
    'seamwise-garment': new () => {readonly $props: SeamwiseGarmentAttributes & Listeners};
  }
}
