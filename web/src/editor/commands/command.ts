/** What can be asked for, whether by a key, by a button or by its name. */

export interface Command {
  /** Stays the same in every language. */
  readonly id: string;
  /** What it is called, in the user's language. */
  readonly title: string;
  /** What else somebody may call it. */
  readonly words?: string;
  /** Why it cannot be done just now; nothing where it can. */
  readonly why?: string | undefined;
  /** Its key, as it is shown. */
  readonly key?: string | undefined;
  readonly run: () => void;
}
