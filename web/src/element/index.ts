/** The parts that the page is built of. */
export * from './desk-element.js';
export {controls} from './style/controls.js';
export {openPrint, readPrintFile} from './print/own-tile.js';
export {icon} from './style/icons.js';
export {keepPreferences, storedPreferences} from './controls/stored-preferences.js';
export type {KeyMap} from './shell/key-map.js';
export {tokens} from './style/tokens.js';
export {lengthUnit} from './controls/number-field.js';
export {cuttingSvg} from './workbench/cutting-svg.js';
export * from './workbench/preferences.js';
export * from './workbench/samples.js';
export * from './workbench/workbench.js';
export {toFailure} from './workbench/latest-solve.js';

import './controls/fit-panel.js';
import './controls/settings.js';
import './lists/tables.js';
import './pattern/pattern-pane.js';
import './print/print-panel.js';
import './shell/garment-choice.js';
import './shell/headline.js';
import './shell/solve-progress.js';
import './shell/key-map.js';
import './symmetry/symmetry-panel.js';
