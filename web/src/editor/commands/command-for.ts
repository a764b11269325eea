import type {Command} from './command.js';

/** Keys that mean the same as the one that is shown. */
const others: Readonly<Record<string, string>> = {'=': '+', '-': '−', F: '0'};

/** Keys as they are shown, and what they do. */
export type KeyList = readonly (readonly [key: string, meaning: string])[];

/** Those of commands that have one. */
export const keysOf = (commands: readonly Command[]): KeyList =>
  commands.flatMap(({key, title}) => (key === undefined ? [] : [[key, title] as const]));

/** The one that a key means. */
export function commandFor(commands: readonly Command[], pressed: string): Command | undefined {
  const name = pressed.length === 1 ? pressed.toUpperCase() : pressed;
  return commands.find(({key}) => key !== undefined && key === (others[name] ?? name));
}
