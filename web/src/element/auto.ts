/** Registers `<seamwise-garment>`; a page only has to import this module. */
import {register} from '../editor/base/register.js';
import {SeamwiseGarment} from './seamwise-garment.js';

export * from './seamwise-garment.js';

if ('document' in globalThis) register('seamwise-garment', SeamwiseGarment);
