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
