/** Parts for placing the print; loaded only then. */
import {defineParts} from '../../editor/parts.js';
import {ToolHint} from '../../editor/pattern/tool-hint.js';
import {registerAll} from '../../editor/base/register.js';
import {PlaceBar} from './place-bar.js';

export function definePlacing(): void {
  defineParts();
  registerAll({'sw-place-bar': PlaceBar, 'sw-tool-hint': ToolHint});
}
