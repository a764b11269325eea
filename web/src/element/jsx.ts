/** Types of the element in framework templates: its attributes and event handlers. */
import type {
  GarmentCamera,
  GarmentLoading,
  GarmentMode,
  GarmentView,
} from './garment/attributes.js';
import type {GarmentEvents, SeamwiseGarment, SeamwiseGarmentEventMap} from './seamwise-garment.js';

/**
 * Attributes in templates. Objects need a framework that sets properties, such as React 19 and Vue.
 */
export interface SeamwiseGarmentAttributes {
  garment?: SeamwiseGarment['garment'];
  size?: string;
  print?: SeamwiseGarment['print'];
  colourway?: string;
  /** Sizes in which the shop prints the fabric, separated by spaces. */
  'print-sizes'?: string;
  symmetry?: SeamwiseGarment['symmetry'];
  /** Greatest movement of an outline. [mm] */
  'max-change-mm'?: number | string;
  view?: GarmentView;
  dummy?: SeamwiseGarment['dummy'];
  fabric?: SeamwiseGarment['fabric'];
  camera?: GarmentCamera;
  turntable?: boolean;
  /** Fabric width of the layout, and the unusable strip along each edge. [cm] */
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

/**
 * `onsolve` and so on, in lower case: React 19 and Preact turn these names into listeners of the
 * same event.
 */
export type SeamwiseGarmentHandlers = {
  [Type in keyof GarmentEvents as `on${Type}`]?: (event: SeamwiseGarmentEventMap[Type]) => void;
};
