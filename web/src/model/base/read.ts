/** Reads values from outside and checks them. */

/** Error that names the wrong field and the required value. */
export class Malformed extends Error {
  override readonly name = 'Malformed';
}

/** A value of any kind in a message, text in quotes. */
export function shown(value: unknown): string {
  if (typeof value === 'string') return JSON.stringify(value.slice(0, 80));
  const isPlain = value === null || !['object', 'function', 'symbol'].includes(typeof value);
  return isPlain ? String(value) : `a value of type ${typeof value}`;
}

/** Checks a value and returns it. @param at name of the value in messages */
export type Read<T> = (value: unknown, at: string) => T;

export function fail(at: string, demand: string): never {
  throw new Malformed(`'${at}' must be ${demand}`);
}

/**
 * Greatest depth of nesting. Files of this project stay far below it; engines overflow at some
 * thousands.
 */
const deepest = 100;

/** Returns whether objects and lists are nested deeper than recursive code should follow. */
export function isTooDeep(value: unknown): boolean {
  let level: readonly unknown[] = [value];
  for (let depth = 0; depth <= deepest; depth++) {
    level = level.filter((one) => typeof one === 'object' && one !== null);
    if (level.length === 0) return false;
    level = level.flatMap((one) => Object.values(one as object) as unknown[]);
  }
  return true;
}

/** A field of any value; undefined where there is none. */
export const fieldOf = (value: unknown, name: string | number): unknown =>
  typeof value === 'object' && value !== null ? Reflect.get(value, name) : undefined;

export const number =
  (low: number, high: number): Read<number> =>
  (value, at) =>
    typeof value === 'number' && value >= low && value <= high
      ? value
      : fail(at, `a number from ${low} to ${high}`);

export const wholeNumber: Read<number> = (value, at) =>
  Number.isSafeInteger(value) && Number(value) >= 0
    ? Number(value)
    : fail(at, 'a whole number, 0 or more');

/** Reads text that matches a pattern. @param demand description of the pattern */
export const text =
  (pattern = /^/, demand = 'text'): Read<string> =>
  (value, at) =>
    typeof value === 'string' && pattern.test(value) ? value : fail(at, demand);

export const flag: Read<boolean> = (value, at) =>
  typeof value === 'boolean' ? value : fail(at, 'true or false');

export const oneOf =
  <const T extends string>(names: readonly T[]): Read<T> =>
  (value, at) =>
    names.find((name) => name === value) ?? fail(at, `one of ${names.join(', ')}`);

/** Reads a list without its entries. It rejects gaps, which `map` and `every` would skip. */
export const list: Read<readonly unknown[]> = (value, at) => {
  if (!Array.isArray(value)) return fail(at, 'a list');
  const entries: readonly unknown[] = value;
  return entries.includes(undefined) ? fail(at, 'a list without gaps') : entries;
};

export const listOf =
  <T>(read: Read<T>): Read<readonly T[]> =>
  (value, at) =>
    list(value, at).map((entry, k) => read(entry, `${at}[${k}]`));

export const pairOf =
  <T>(read: Read<T>): Read<readonly [T, T]> =>
  (value, at) => {
    if (!Array.isArray(value) || value.length !== 2) return fail(at, 'a list of two');
    const [first, second] = value as readonly unknown[];
    return [read(first, `${at}[0]`), read(second, `${at}[1]`)];
  };

function entriesOf(value: unknown, at: string): [string, unknown][] {
  return typeof value === 'object' && value !== null && !Array.isArray(value)
    ? Object.entries(value)
    : fail(at, 'an object');
}

export const recordOf =
  <T>(read: Read<T>): Read<Readonly<Record<string, T>>> =>
  (value, at) =>
    Object.fromEntries(
      entriesOf(value, at).map(([name, entry]) => [name, read(entry, `${at}.${name}`)]),
    );

type Fields = Readonly<Record<string, Read<unknown>>>;
type Needed<F extends Fields> = {readonly [Name in keyof F]: ReturnType<F[Name]>};
type Optional<F extends Fields> = {readonly [Name in keyof F]?: ReturnType<F[Name]>};

/** Reads an object by its fields; unknown fields are omitted. */
export function shape<Must extends Fields>(must: Must): Read<Needed<Must>>;
export function shape<Must extends Fields, May extends Fields>(
  must: Must,
  may: May,
): Read<Needed<Must> & Optional<May>>;
export function shape(must: Fields, may: Fields = {}): Read<Readonly<Record<string, unknown>>> {
  return (value, at) => {
    const given = new Map(entriesOf(value, at));
    const name = (field: string): string => (at === '' ? field : `${at}.${field}`);
    return Object.fromEntries([
      ...Object.entries(must).map(([field, read]) => [field, read(given.get(field), name(field))]),
      ...Object.entries(may)
        .filter(([field]) => given.get(field) !== undefined)
        .map(([field, read]) => [field, read(given.get(field), name(field))]),
    ]) as Readonly<Record<string, unknown>>;
  };
}
