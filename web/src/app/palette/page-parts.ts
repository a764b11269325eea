import type {Command} from '../../commands/editor-command.js';
import type {Editor} from '../../editor/editor.js';
import type {Format} from '../../texts/format.js';
import type {GarmentChoice} from '../../editor/shell/garment-choice.js';
import type {Samples} from '../../workbench/samples.js';
import {keyOf, titleOf, type ShortcutId} from '../../commands/shortcuts.js';
import type {Texts} from '../../texts/texts.js';
import type {Workbench} from '../../workbench/workbench.js';

/** Parts of the page that commands use. */
export interface PageParts {
  readonly workbench: Workbench;
  readonly texts: Texts;
  readonly format: Format;
  readonly samples: Samples | undefined;
  readonly editor: Editor;
  readonly garments: GarmentChoice;
  readonly saves: {
    readonly project: () => void;
    readonly result: () => void;
    readonly picture: () => void;
    readonly cut: () => void;
    readonly link: () => void;
    readonly other: (ending: string, content: Blob) => void;
  };
  readonly openGarment: () => void;
  readonly openPrint: () => void;
  readonly showProjects: () => void;
}

/** Returns a command with a keyboard shortcut. */
export const withKey = (
  texts: Texts,
  id: ShortcutId,
  more: Omit<Command, 'id' | 'title' | 'key'> & {readonly title?: string},
): Command => ({id, title: titleOf(id, texts), key: keyOf(id, texts), ...more});
