/**
 * Does something again after each change: once for changes that come together, and once more for those that come
 * while it is at work. What fails is said, and the next change tries again.
 * @param work  what to do; it may throw
 * @param told  hears of an error, and what it is
 * @param quiet how long no change may come before it begins [ms]
 * @returns what to call at a change
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
