/** The command palette, loaded when it is first opened. */
import type {Workbench} from '../../workbench/workbench.js';
import {allCommands} from './page-list.js';
import type {PageParts} from './page-parts.js';
import {CommandPalette} from './palette.js';

const name = 'sw-commands';

/** Opens or closes the palette of a page. @param parts undefined while no command is available */
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
