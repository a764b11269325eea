/** Registers the fabric layout; loaded on demand. */
import {registerAll} from '../base/register.js';
import {ClothFlaws} from './marker-flaws.js';
import {ClothPane} from './marker-pane.js';
import {ClothPanel} from './marker-panel.js';

export const defineCloth = (): void => {
  registerAll({
    'sw-cloth': ClothPane,
    'sw-cloth-panel': ClothPanel,
    'sw-cloth-flaws': ClothFlaws,
  });
};
