/** Registers the fabric layout; loaded on demand. */
import {registerAll} from '../base/register.js';
import {MarkerFlaws} from './marker-flaws.js';
import {MarkerGarments} from './marker-garments.js';
import {MarkerPane} from './marker-pane.js';
import {MarkerPanel} from './marker-panel.js';

export const defineMarker = (): void => {
  registerAll({
    'sw-marker-pane': MarkerPane,
    'sw-marker-panel': MarkerPanel,
    'sw-marker-flaws': MarkerFlaws,
    'sw-marker-garments': MarkerGarments,
  });
};
