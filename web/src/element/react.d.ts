/** `seamwise/react`: registers `<seamwise-garment>`, and tells TypeScript what it takes in the JSX of React 19. */
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
