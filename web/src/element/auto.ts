/** Registers `<seamwise-garment>`: importing this is all that a page has to do. */
import {register} from '../editor/base/register.js';
import {SeamwiseGarment} from './seamwise-garment.js';

export * from './seamwise-garment.js';

if ('document' in globalThis) register('seamwise-garment', SeamwiseGarment);
