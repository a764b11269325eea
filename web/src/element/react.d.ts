/**
 * `seamwise/react`: registers `<seamwise-garment>`, and declares its attributes for JSX in React
 * 19.
 */
export * from './auto.js';

import type {DetailedHTMLProps, HTMLAttributes} from 'react';

import type {SeamwiseGarmentAttributes, SeamwiseGarmentHandlers} from './jsx.js';
import type {SeamwiseGarment} from './seamwise-garment.js';

declare module 'react' {
  namespace JSX {
    interface IntrinsicElements {
      'seamwise-garment': SeamwiseGarmentAttributes &
        SeamwiseGarmentHandlers &
        Omit<
          DetailedHTMLProps<HTMLAttributes<SeamwiseGarment>, SeamwiseGarment>,
          keyof SeamwiseGarmentAttributes | keyof SeamwiseGarmentHandlers
        >;
    }
  }
}
