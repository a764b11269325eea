/**
 * The parts that the first result needs, by tag name; `later-parts.ts` has the others. Importing a
 * part registers nothing; `defineParts` does.
 */
import {NumberField} from './controls/number-field.js';
import {Settings} from './controls/settings.js';
import {BeforeButton} from './pattern/before-button.js';
import {Legend} from './pattern/legend.js';
import {PatternPane} from './pattern/pattern-pane.js';
import {Toolbar} from './pattern/toolbar.js';
import {ZoomMenu} from './pattern/zoom-menu.js';
import {PrintGallery} from './print/print-gallery.js';
import {PrintPanel} from './print/print-panel.js';
import {RepeatFields} from './print/repeat-fields.js';
import {registerAll} from './base/register.js';
import {GarmentChoice} from './shell/garment-choice.js';
import {Headline} from './shell/headline.js';
import {NoticeBar} from './shell/notice.js';
import {SolveProgress} from './shell/solve-progress.js';

const parts: Readonly<Record<string, CustomElementConstructor>> = {
  'sw-before': BeforeButton,
  'sw-garment-choice': GarmentChoice,
  'sw-headline': Headline,
  'sw-legend': Legend,
  'sw-notice': NoticeBar,
  'sw-number-field': NumberField,
  'sw-pattern': PatternPane,
  'sw-print-gallery': PrintGallery,
  'sw-print-panel': PrintPanel,
  'sw-progress': SolveProgress,
  'sw-repeat-fields': RepeatFields,
  'sw-settings': Settings,
  'sw-toolbar': Toolbar,
  'sw-zoom': ZoomMenu,
};

export const defineParts = (): void => {
  registerAll(parts);
};
