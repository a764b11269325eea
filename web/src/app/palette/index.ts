/** The list of commands, loaded when it is opened for the first time. */
import type {Workbench} from '../../editor/index.js';
import {allCommands} from './page-list.js';
import type {PageParts} from './page-parts.js';
import {CommandPalette} from './palette.js';

const name = 'sw-commands';

/** Opens the list in a page, or closes it. @param parts undefined while there is nothing to be done */
export async function toggleCommands(
  workbench: Workbench,
  root: HTMLElement | DocumentFragment,
  parts: () => PageParts | undefined,
): Promise<void> {
  if (!customElements.get(name)) customElements.define(name, CommandPalette);
  let palette = root.querySelector<CommandPalette>(name);
  if (!palette) {
    palette = new CommandPalette();
    palette.workbench = workbench;
    palette.commands = () => {
      const present = parts();
      return present ? allCommands(present) : [];
    };
    root.append(palette);
  }
  await palette.toggle();
}
