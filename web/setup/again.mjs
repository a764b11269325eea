/**
 * Repeats a task after changes: once for changes that come together, and once more for those during
 * the task. After an error, the next change tries again.
 * @param work  task; may throw
 * @param told  called with each error
 * @param quiet  time without changes before the task starts [ms]
 * @returns function to call at each change
 */
export function again(work, told, quiet = 100) {
  let timer;
  let isAtWork = false;
  let isStale = false;
  const begin = async () => {
    if (isAtWork) return;
    isAtWork = true;
    while (isStale) {
      isStale = false;
      await Promise.resolve().then(work).catch(told);
    }
    isAtWork = false;
  };
  return () => {
    isStale = true;
    clearTimeout(timer);
    timer = setTimeout(() => void begin(), quiet);
  };
}
