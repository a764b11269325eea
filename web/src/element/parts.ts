/** The parts by the names that templates call them. Importing a part registers nothing: whoever uses them does. */
import {FitPanel} from './controls/fit-panel.js';
import {NumberField} from './controls/number-field.js';
import {Settings} from './controls/settings.js';
import {LensStrip} from './lens/lens-strip.js';
import {SeamLens} from './lens/lens.js';
import {PieceTable} from './lists/piece-table.js';
import {SeamTable} from './lists/seam-table.js';
import {Tables} from './lists/tables.js';
import {KeepMenu} from './pattern/keep-menu.js';
import {Legend} from './pattern/legend.js';
import {GrainQuestion} from './pattern/grain-question.js';
import {PatternPane} from './pattern/pattern-pane.js';
import {TiesMenu} from './pattern/ties-menu.js';
import {ToolHint} from './pattern/tool-hint.js';
import {Toolbar} from './pattern/toolbar.js';
import {UnitsQuestion} from './pattern/units-question.js';
import {WipeHandle} from './pattern/wipe-handle.js';
import {ZoomMenu} from './pattern/zoom-menu.js';
import {DoubtfulTile} from './print/doubtful-tile.js';
import {PrintGallery} from './print/print-gallery.js';
import {PrintPanel} from './print/print-panel.js';
import {RepeatFields} from './print/repeat-fields.js';
import {FileSizeNote} from './print/file-size-note.js';
import {MeasureDialog} from './print/measure-dialog.js';
import {TileRepeatChoice} from './print/tile-repeat-choice.js';
import {TileReport} from './print/tile-report.js';
import {register} from './register.js';
import {KeepImproving} from './remedies/keep-improving.js';
import {StaysOff} from './remedies/stays-off.js';
import {GarmentChoice} from './shell/garment-choice.js';
import {Headline} from './shell/headline.js';
import {KeyMap} from './shell/key-map.js';
import {NoticeBar} from './shell/notice.js';
import {SolveProgress} from './shell/solve-progress.js';
import {WaysOut} from './shell/ways-out.js';
import {SymmetryPanel} from './symmetry/symmetry-panel.js';

const parts: Readonly<Record<string, CustomElementConstructor>> = {
  'sw-doubtful-tile': DoubtfulTile,
  'sw-file-size': FileSizeNote,
  'sw-fit-panel': FitPanel,
  'sw-garment-choice': GarmentChoice,
  'sw-grain-question': GrainQuestion,
  'sw-headline': Headline,
  'sw-keep-menu': KeepMenu,
  'sw-key-map': KeyMap,
  'sw-legend': Legend,
  'sw-keep-improving': KeepImproving,
  'sw-lens': SeamLens,
  'sw-lens-strip': LensStrip,
  'sw-measure': MeasureDialog,
  'sw-notice': NoticeBar,
  'sw-number-field': NumberField,
  'sw-pattern': PatternPane,
  'sw-piece-table': PieceTable,
  'sw-print-gallery': PrintGallery,
  'sw-print-panel': PrintPanel,
  'sw-progress': SolveProgress,
  'sw-repeat-fields': RepeatFields,
  'sw-seam-table': SeamTable,
  'sw-settings': Settings,
  'sw-stays-off': StaysOff,
  'sw-symmetry-panel': SymmetryPanel,
  'sw-tables': Tables,
  'sw-ties-menu': TiesMenu,
  'sw-tile-repeat': TileRepeatChoice,
  'sw-tile-report': TileReport,
  'sw-tool-hint': ToolHint,
  'sw-toolbar': Toolbar,
  'sw-units-question': UnitsQuestion,
  'sw-ways-out': WaysOut,
  'sw-wipe-handle': WipeHandle,
  'sw-zoom': ZoomMenu,
};

/** Registers all of them. */
export function defineParts(): void {
  for (const [name, part] of Object.entries(parts)) register(name, part);
}
