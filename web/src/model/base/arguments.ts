/** Checks arguments of public functions, which callers without types may confuse. */
import {SolverError} from './failure.js';
import {fail, Malformed, type Read} from './read.js';

/** One check for each field of `T`, so that a new field does not compile without its check. */
export type Checks<T> = {readonly [Name in keyof Required<T>]: Read<unknown>};

const isObject = (value: unknown): value is object => typeof value === 'object' && value !== null;

/** Accepts an object with these fields and no others. Fields that are not `needed` may be missing. */
export const fields =
  <T extends object>(checks: Checks<T>, ...needed: readonly (keyof T & string)[]): Read<T> =>
  (value, at) => {
    if (!isObject(value) || Array.isArray(value)) return fail(at, 'an object');
    const known = new Map(Object.entries<Read<unknown>>(checks));
    for (const name of needed) known.get(name)?.(Reflect.get(value, name), `${at}.${name}`);
    for (const [name, field] of Object.entries(value) as [string, unknown][]) {
      const check = known.get(name);
      if (!check) {
        throw new Malformed(
          `'${at}' has no field '${name}'; it has ${[...known.keys()].sort().join(', ')}`,
        );
      }
      if (field !== undefined) check(field, `${at}.${name}`);
    }
    return value as T;
  };

/** Accepts an object with at least these fields. */
export const having =
  <T extends object>(checks: Readonly<Partial<Record<keyof T & string, Read<unknown>>>>): Read<T> =>
  (value, at) => {
    if (!isObject(value) || Array.isArray(value)) return fail(at, 'an object');
    for (const [name, check] of Object.entries<Read<unknown> | undefined>(checks)) {
      check?.(Reflect.get(value, name), `${at}.${name}`);
    }
    return value as T;
  };

/** Accepts any value but one with a part that throws; the function itself checks the parts. */
export const readable = <T>(value: T): T => {
  const parts = new Set<unknown>([value]);
  for (const part of parts) {
    if (!isObject(part) || ArrayBuffer.isView(part)) continue;
    for (const inner of Object.values(part) as unknown[]) if (isObject(inner)) parts.add(inner);
  }
  return value;
};

/** Accepts a missing value, too. */
export const optional =
  <T>(check: Read<T>): Read<T | undefined> =>
  (value, at) =>
    value === undefined ? undefined : check(value, at);

/** Accepts a value that one of the checks accepts. @param demand description of all of them */
export const either =
  (demand: string, ...checks: readonly Read<unknown>[]): Read<unknown> =>
  (value, at) => {
    const isKnown = checks.some((check) => {
      try {
        check(value, at);
        return true;
      } catch (error) {
        if (error instanceof Malformed) return false;
        throw error;
      }
    });
    return isKnown ? value : fail(at, demand);
  };

/** Accepts any value; the function itself checks it, and names it in its errors. */
export const checkedLater: Read<unknown> = (value) => value;

export const callback: Read<unknown> = (value, at) =>
  typeof value === 'function' ? value : fail(at, 'a function');

export const signal: Read<unknown> = (value, at) =>
  value instanceof AbortSignal ? value : fail(at, 'an AbortSignal');

export const date: Read<Date> = (value, at) =>
  value instanceof Date && Number.isFinite(value.getTime()) ? value : fail(at, 'a valid Date');

export const bytes: Read<Uint8Array> = (value, at) => {
  if (!(value instanceof Uint8Array)) return fail(at, 'a Uint8Array');
  value.subarray(); // throws once the buffer was transferred elsewhere
  return value;
};

/** An argument of a function: its name, its value, and its check. */
type Argument = readonly [name: string, value: unknown, check: Read<unknown>];

/**
 * Checks the arguments of a call.
 * @throws {SolverError} `options`, with the function, the argument and the accepted values
 */
export function checkArguments(call: string, ...given: readonly Argument[]): void {
  for (const [name, value, check] of given) {
    try {
      check(value, name);
    } catch (cause) {
      if (cause instanceof SolverError) throw cause;
      // the value's own code has thrown, such as a getter or a proxy
      const complaint =
        cause instanceof Malformed ? cause.message : `'${name}' has a part that cannot be read`;
      throw new SolverError({code: 'options', message: `${call}: ${complaint}.`}, {cause});
    }
  }
}
