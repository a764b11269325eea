import type {Command} from './command.js';

/** Keys equivalent to the displayed one. */
const others: Readonly<Record<string, string>> = {'=': '+', '-': '−', F: '0'};

/** Keys as displayed, and their meaning. */
export type KeyList = readonly (readonly [key: string, meaning: string])[];

/** The keys of the commands that have one. */
export const keysOf = (commands: readonly Command[]): KeyList =>
  commands.flatMap(({key, title}) => (key === undefined ? [] : [[key, title] as const]));

/** Returns the command of a pressed key. */
export function commandFor(commands: readonly Command[], pressed: string): Command | undefined {
  const name = pressed.length === 1 ? pressed.toUpperCase() : pressed;
  return commands.find(({key}) => key !== undefined && key === (others[name] ?? name));
}
