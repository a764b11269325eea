/** Keys that work wherever the focus is. */

export interface PageCommands {
  readonly undo: () => void;
  readonly redo: () => void;
  readonly save: () => void;
  readonly open: () => void;
  readonly keys: () => void;
}

/** In a field, undo belongs to what is being typed. */
const isTyping = (event: KeyboardEvent): boolean => {
  const [target] = event.composedPath();
  return target instanceof HTMLInputElement && ['text', 'number'].includes(target.type);
};

export function pageKeys(commands: PageCommands, signal: AbortSignal): void {
  addEventListener(
    'keydown',
    (event) => {
      const command = commandOf(event, commands);
      if (!command) return;
      event.preventDefault();
      command();
    },
    {signal},
  );
}

function commandOf(event: KeyboardEvent, commands: PageCommands): (() => void) | undefined {
  if (event.key === '?') return isTyping(event) ? undefined : commands.keys;
  if (!(event.ctrlKey || event.metaKey) || event.altKey) return undefined;
  switch (event.key.toLowerCase()) {
    case 'z':
      if (isTyping(event)) return undefined;
      return event.shiftKey ? commands.redo : commands.undo;
    case 'y':
      return isTyping(event) ? undefined : commands.redo;
    case 's':
      return commands.save;
    case 'o':
      return commands.open;
    default:
      return undefined;
  }
}
