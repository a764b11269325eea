/** The parts that the page is built of. */
export * from './desk-element.js';
export {controls} from './style/controls.js';
export {openPrint, readPrintFile} from './print/own-tile.js';
export {icon} from './style/icons.js';
export {defineEditor, type Editor} from './editor/editor.js';
export type {PatternPane} from './pattern/pattern-pane.js';
export {loadTexts, textsOf, type Texts} from './texts/texts.js';
export {placeUnder} from './style/place-under.js';
export {tokens} from './style/tokens.js';
export {lengthUnit, type NumberField} from './controls/number-field.js';
export * from './workbench/preferences.js';
export * from './workbench/samples.js';
export * from './workbench/workbench.js';
export {toFailure} from './workbench/latest-solve.js';
export {spokenFailure} from './workbench/spoken-failure.js';
export {leaseSolver} from '../solver/pool.js';
