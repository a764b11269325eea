/** Registers the fabric layout; loaded on demand. */
import {registerAll} from '../base/register.js';
import {ClothFlaws} from './cloth-flaws.js';
import {ClothPane} from './cloth-pane.js';
import {ClothPanel} from './cloth-panel.js';

export const defineCloth = (): void => {
  registerAll({
    'sw-cloth': ClothPane,
    'sw-cloth-panel': ClothPanel,
    'sw-cloth-flaws': ClothFlaws,
  });
};
