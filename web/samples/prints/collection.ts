/** The collection, in the order of its catalogue. */
import {botanicalPrints} from './botanical-prints.js';
import type {Design} from './design.js';
import {geometricPrints} from './geometric-prints.js';
import {tailoredPrints} from './tailored-prints.js';

export const collection: readonly Design[] = [
  ...botanicalPrints,
  ...geometricPrints,
  ...tailoredPrints,
];
