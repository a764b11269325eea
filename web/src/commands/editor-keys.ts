/** Keys that work anywhere in the editor. */
import {shortcutFor, shortcuts, type ShortcutIn} from './shortcuts.js';

/** Functions that shortcuts run; a page adds its own to the editor's. */
export type KeyCommands = Readonly<Partial<Record<ShortcutIn<'page' | 'editor'>, () => void>>>;

/** Runs the command of a key event, unless another listener has already handled the event. */
export function editorKeys(event: KeyboardEvent, commands: KeyCommands): void {
  const id = event.defaultPrevented ? undefined : shortcutFor(event, ['page', 'editor']);
  const command = id && commands[id];
  // undo in a field applies to the text of the field
  if (!command || (shortcuts[id].where === 'editor' && isTyping(event))) return;
  event.preventDefault();
  command();
}

/** Returns whether the pattern may use a key event: unhandled, outside fields and open dialogs. */
export const isFree = (event: KeyboardEvent): boolean =>
  !event.defaultPrevented &&
  !isTyping(event) &&
  !event.composedPath().some((one) => one instanceof HTMLDialogElement && one.open);

const isTyping = (event: KeyboardEvent): boolean => {
  const [target] = event.composedPath();
  if (target instanceof HTMLSelectElement) return true; // a letter key selects an option
  return target instanceof HTMLInputElement && ['text', 'number'].includes(target.type);
};
