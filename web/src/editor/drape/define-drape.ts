/** Registers the drape; loaded on demand. */
import {registerAll} from '../base/register.js';
import {Legend} from '../pattern/legend.js';
import {WornPane} from './drape-pane.js';

export const defineWorn = (): void => {
  registerAll({'sw-legend': Legend, 'sw-worn': WornPane});
};
