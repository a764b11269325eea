/** Parts that the page is built from. */
export * from './base/workbench-element.js';
export {controls} from './style/controls.js';
export {openPrint} from './print/own-tile.js';
export {printFiles} from './print/print-files.js';
export {icon} from './style/icons.js';
export {defineEditor, editorViews, type Editor} from './editor.js';
export {focused} from './base/focused.js';
export {canAlign} from './commands/can-align.js';
export type {Command} from './commands/command.js';
export {keyOf, titleOf, type ShortcutId} from './commands/shortcuts.js';
export {redoWords, undoWords} from './commands/step-words.js';
export {
  solveSettingsOf,
  presetNames,
  presetOf,
  withSolveSettings,
  withPreset,
} from './controls/presets.js';
export {languageNames} from './controls/settings.js';
export {withAll} from '../workbench/symmetry-steps.js';
export {withoutPin} from './lists/choices.js';
export {pieceRows, seamRows, worstSeams} from './lists/rows.js';
export {turnPiece} from './lists/turn-piece.js';
export {togglePart} from './lists/keeping.js';
export {patternCommands} from './pattern/pattern-commands.js';
export {missing} from './print/choices.js';
export {pictureOfTile} from './print/own-print.js';
export {kindOf, looksLikePicture} from './print/read-picture.js';
export type {PhotoKeeper} from './photo/photo-keeper.js';
export {remedied} from './remedies/apply.js';
export {improvementOffer} from './remedies/keep-improving.js';
export {remedyWords} from './remedies/stays-off.js';
export type {GarmentChoice} from './shell/garment-choice.js';
export type {PatternPane} from './pattern/pattern-pane.js';
export type {MarkerPane} from './marker/marker-pane.js';
export type {DrapePane} from './drape/drape-pane.js';
export type {Format} from '../texts/format.js';
export {loadTexts, textsOf, type Texts} from '../texts/texts.js';
export {placeUnder} from './style/place-under.js';
export {tokens} from './style/tokens.js';
export {lengthUnit, type NumberField} from './controls/number-field.js';
export * from '../texts/preferences.js';
export * from '../workbench/allowances.js';
export * from '../workbench/samples.js';
export * from '../workbench/workbench.js';
export {toFailure} from '../workbench/latest-solve.js';
export {spokenFailure} from '../workbench/spoken-failure.js';
export {leaseSolver} from '../solver/pool.js';
