/** Keys that work wherever in the editor the focus is. */

export interface EditorCommands {
  readonly undo: () => void;
  readonly redo: () => void;
  /** Shows and hides the map of keys. */
  readonly keys: () => void;
}

/** Does what a key asks for, unless somebody has done so already. */
export function editorKeys(event: KeyboardEvent, commands: EditorCommands): void {
  // in a field, undo belongs to what is being typed
  if (event.defaultPrevented || isTyping(event)) return;
  const command = commandOf(event, commands);
  if (!command) return;
  event.preventDefault();
  command();
}

const isTyping = (event: KeyboardEvent): boolean => {
  const [target] = event.composedPath();
  return target instanceof HTMLInputElement && ['text', 'number'].includes(target.type);
};

function commandOf(event: KeyboardEvent, commands: EditorCommands): (() => void) | undefined {
  if (event.key === '?') return commands.keys;
  if (!(event.ctrlKey || event.metaKey) || event.altKey) return undefined;
  switch (event.key.toLowerCase()) {
    case 'z':
      return event.shiftKey ? commands.redo : commands.undo;
    case 'y':
      return commands.redo;
    default:
      return undefined;
  }
}
