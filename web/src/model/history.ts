/** Steps that can be taken back and taken again. Plain data; every function gives a new history. */

export interface History<State> {
  readonly past: readonly State[];
  readonly present: State;
  /** What was taken back, the nearest first. */
  readonly future: readonly State[];
}

/** Steps beyond this are forgotten. */
const depth = 300;

export const begun = <State>(present: State): History<State> => ({past: [], present, future: []});

/** The same steps, in another form. */
export const mapped = <From, To>(
  {past, present, future}: History<From>,
  to: (state: From) => To,
): History<To> => ({past: past.map(to), present: to(present), future: future.map(to)});

/** A new step; what had been taken back is gone. */
export const stepped = <State>({past, present}: History<State>, next: State): History<State> => ({
  past: [...past, present].slice(-depth),
  present: next,
  future: [],
});

/** The same step, seen otherwise: a slider still being dragged, a view that was moved. */
export const amended = <State>(history: History<State>, present: State): History<State> => ({
  ...history,
  present,
});

/** One step back, if there is one. */
export function undone<State>({past, present, future}: History<State>): History<State> | undefined {
  const before = past.at(-1);
  if (before === undefined) return undefined;
  return {past: past.slice(0, -1), present: before, future: [present, ...future]};
}

/** One step forward again, if there is one. */
export function redone<State>({past, present, future}: History<State>): History<State> | undefined {
  const [next, ...later] = future;
  if (next === undefined) return undefined;
  return {past: [...past, present], present: next, future: later};
}
