/** A command that a key, a button or its name runs. */

export interface Command {
  /** The same in every language. */
  readonly id: string;
  /** Name in the user's language. */
  readonly title: string;
  /** Further search terms. */
  readonly words?: string;
  /** Reason that the command is unavailable; undefined if it is available. */
  readonly why?: string | undefined;
  /** Key as displayed. */
  readonly key?: string | undefined;
  readonly run: () => void;
}

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
