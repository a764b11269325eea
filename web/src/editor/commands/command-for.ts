import type {Command} from './command.js';

/** Keys that mean the same as the one that is shown. */
const others: Readonly<Record<string, string>> = {'=': '+', '-': '−', F: '0'};

/** The one that a key means. */
export function commandFor(commands: readonly Command[], pressed: string): Command | undefined {
  const name = pressed.length === 1 ? pressed.toUpperCase() : pressed;
  return commands.find(({key}) => key !== undefined && key === (others[name] ?? name));
}
