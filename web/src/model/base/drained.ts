/** Runs stepwise work to its end at once and returns its result. */
export function drained<Result>(steps: Iterator<unknown, Result>): Result {
  for (;;) {
    const step = steps.next();
    if (step.done === true) return step.value;
  }
}
