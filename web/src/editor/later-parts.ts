/** Parts that are first visible after the first result or after a user's request. */
import {SolvePanel} from './controls/solve-panel.js';
import {LensStrip} from './lens/lens-strip.js';
import {SeamLens} from './lens/lens.js';
import {PieceTable} from './lists/piece-table.js';
import {SeamMenu} from './lists/seam-menu.js';
import {SeamTable} from './lists/seam-table.js';
import {FoldBar} from './folding/fold-bar.js';
import {GrainQuestion} from './pattern/grain-question.js';
import {KeepMenu} from './pattern/keep-menu.js';
import {TiesMenu} from './pattern/ties-menu.js';
import {ToolHint} from './pattern/tool-hint.js';
import {UnitsQuestion} from './pattern/units-question.js';
import {WipeHandle} from './pattern/wipe-handle.js';
import {DoubtfulTile} from './print/doubtful-tile.js';
import {FileSizeNote} from './print/file-size-note.js';
import {MeasureDialog} from './print/measure-dialog.js';
import {PrintSize} from './print/print-size.js';
import {TileRepeatChoice} from './print/tile-repeat-choice.js';
import {TileReport} from './print/tile-report.js';
import {registerAll} from './base/register.js';
import {BetterMatch} from './remedies/better-match.js';
import {RemedyList} from './remedies/remedy-list.js';
import {SewBar} from './sewing/sew-bar.js';
import {KeyMap} from './shell/key-map.js';
import {WaysOut} from './shell/ways-out.js';
import {SymmetryPanel} from './symmetry/symmetry-panel.js';

const parts: Readonly<Record<string, CustomElementConstructor>> = {
  'sw-better-match': BetterMatch,
  'sw-doubtful-tile': DoubtfulTile,
  'sw-file-size': FileSizeNote,
  'sw-solve-panel': SolvePanel,
  'sw-fold-bar': FoldBar,
  'sw-grain-question': GrainQuestion,
  'sw-keep-menu': KeepMenu,
  'sw-key-map': KeyMap,
  'sw-lens': SeamLens,
  'sw-lens-strip': LensStrip,
  'sw-measure': MeasureDialog,
  'sw-piece-table': PieceTable,
  'sw-print-size': PrintSize,
  'sw-seam-table': SeamTable,
  'sw-remedies': RemedyList,
  'sw-seam-menu': SeamMenu,
  'sw-sew-bar': SewBar,
  'sw-symmetry-panel': SymmetryPanel,
  'sw-ties-menu': TiesMenu,
  'sw-tile-repeat': TileRepeatChoice,
  'sw-tile-report': TileReport,
  'sw-tool-hint': ToolHint,
  'sw-units-question': UnitsQuestion,
  'sw-ways-out': WaysOut,
  'sw-wipe-handle': WipeHandle,
};

export const defineLaterParts = (): void => {
  registerAll(parts);
};
