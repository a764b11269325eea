/** Keys of the page, beside those of its editor. */

export interface PageCommands {
  readonly save: () => void;
  readonly open: () => void;
  /** Whatever else is pressed. */
  readonly other: (event: KeyboardEvent) => void;
}

export function pageKeys(commands: PageCommands, signal: AbortSignal): void {
  addEventListener(
    'keydown',
    (event) => {
      const command = commandOf(event, commands);
      if (!command) {
        commands.other(event);
        return;
      }
      event.preventDefault();
      command();
    },
    {signal},
  );
}

function commandOf(event: KeyboardEvent, commands: PageCommands): (() => void) | undefined {
  if (!(event.ctrlKey || event.metaKey) || event.altKey) return undefined;
  switch (event.key.toLowerCase()) {
    case 's':
      return commands.save;
    case 'o':
      return commands.open;
    default:
      return undefined;
  }
}
