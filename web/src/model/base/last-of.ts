/** A function that caches its last result: the same arguments give the same object. */
export function lastOf<Arguments extends readonly unknown[], Result>(
  make: (...given: Arguments) => Result,
): (...given: Arguments) => Result {
  let last: {readonly given: Arguments; readonly result: Result} | undefined;
  return (...given) => {
    if (!last?.given.every((value, k) => value === given[k])) {
      last = {given, result: make(...given)};
    }
    return last.result;
  };
}
