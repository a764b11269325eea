/** Undo and redo. A history is plain data; every function returns a new one. */

export interface History<State> {
  readonly past: readonly State[];
  readonly present: State;
  /** Undone states, the nearest first. */
  readonly future: readonly State[];
}

/** Greatest number of past steps; older ones are dropped. */
const depth = 300;

export const begun = <State>(present: State): History<State> => ({past: [], present, future: []});

/** The same steps with every state converted. */
export const mapped = <From, To>(
  {past, present, future}: History<From>,
  to: (state: From) => To,
): History<To> => ({past: past.map(to), present: to(present), future: future.map(to)});

/** Adds a step and drops all undone ones. */
export const stepped = <State>({past, present}: History<State>, next: State): History<State> => ({
  past: [...past, present].slice(-depth),
  present: next,
  future: [],
});

/** Replaces the present state without a new step, such as for a dragged slider or a moved view. */
export const amended = <State>(history: History<State>, present: State): History<State> => ({
  ...history,
  present,
});

/** Goes back one step; undefined if there is none. */
export function undone<State>({past, present, future}: History<State>): History<State> | undefined {
  const before = past.at(-1);
  if (before === undefined) return undefined;
  return {past: past.slice(0, -1), present: before, future: [present, ...future]};
}

/** Goes forward one step; undefined if there is none. */
export function redone<State>({past, present, future}: History<State>): History<State> | undefined {
  const [next, ...later] = future;
  if (next === undefined) return undefined;
  return {past: [...past, present], present: next, future: later};
}
