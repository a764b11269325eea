/** What shows a garment as it is worn: loaded by whoever does. */
import {registerAll} from '../base/register.js';
import {Legend} from '../pattern/legend.js';
import {WipeHandle} from '../pattern/wipe-handle.js';
import {WornPane} from './worn-pane.js';

export const defineWorn = (): void => {
  registerAll({'sw-legend': Legend, 'sw-wipe-handle': WipeHandle, 'sw-worn': WornPane});
};
