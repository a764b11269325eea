/** The element as frameworks' templates write it: its attributes, and how they listen to it. */
import type {GarmentLoading, GarmentMode, GarmentView} from './garment/attributes.js';
import type {GarmentEvents, SeamwiseGarment, SeamwiseGarmentEventMap} from './seamwise-garment.js';

/** What templates may say. Objects are set as properties by those that can, such as React 19 and Vue. */
export interface SeamwiseGarmentAttributes {
  garment?: SeamwiseGarment['garment'];
  size?: string;
  print?: SeamwiseGarment['print'];
  colourway?: string;
  symmetry?: SeamwiseGarment['symmetry'];
  /** No outline moves further than this. [mm] */
  'max-change-mm'?: number | string;
  view?: GarmentView;
  /** Of the cloth on which it is laid, and of what is of no use along each edge. [cm] */
  'cloth-width'?: number | string;
  selvedge?: number | string;
  mode?: GarmentMode;
  loading?: GarmentLoading;
  units?: SeamwiseGarment['units'];
  locale?: string;
  lang?: string;
  alt?: string;
  'worker-url'?: string;
  'wasm-url'?: string;
  name?: string;
  required?: boolean;
  disabled?: boolean;
  prints?: SeamwiseGarment['prints'];
  messages?: SeamwiseGarment['messages'];
  value?: string;
}

/** `onsolve` and so on, in lower case: the names that React 19 and Preact turn into listeners of the very event. */
export type SeamwiseGarmentHandlers = {
  [Type in keyof GarmentEvents as `on${Type}`]?: (event: SeamwiseGarmentEventMap[Type]) => void;
};
