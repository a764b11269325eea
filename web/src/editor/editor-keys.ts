/** Keys that work wherever in the editor the focus is. */
import {shortcutFor, shortcuts, type ShortcutIn} from './commands/shortcuts.js';

/** What there is to be asked for; a page adds its own to the editor's. */
export type KeyCommands = Readonly<Partial<Record<ShortcutIn<'page' | 'editor'>, () => void>>>;

/** Does what a key asks for, unless somebody has done so already. */
export function editorKeys(event: KeyboardEvent, commands: KeyCommands): void {
  const id = event.defaultPrevented ? undefined : shortcutFor(event, ['page', 'editor']);
  const command = id && commands[id];
  // in a field, undo belongs to what is being typed
  if (!command || (shortcuts[id].where === 'editor' && isTyping(event))) return;
  event.preventDefault();
  command();
}

/** Whether a key that nobody has taken may be one of the pattern's: not in a field, nor in a dialog. */
export const isFree = (event: KeyboardEvent): boolean =>
  !event.defaultPrevented &&
  !isTyping(event) &&
  !event.composedPath().some((one) => one instanceof HTMLDialogElement && one.open);

const isTyping = (event: KeyboardEvent): boolean => {
  const [target] = event.composedPath();
  if (target instanceof HTMLSelectElement) return true; // a letter chooses
  return target instanceof HTMLInputElement && ['text', 'number'].includes(target.type);
};
