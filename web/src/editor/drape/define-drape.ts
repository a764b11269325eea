/** Registers the drape; loaded on demand. */
import {registerAll} from '../base/register.js';
import {Legend} from '../pattern/legend.js';
import {DrapePane} from './drape-pane.js';

export const defineDrape = (): void => {
  registerAll({'sw-legend': Legend, 'sw-drape-pane': DrapePane});
};
