import {parseArgs} from 'node:util';

import type {PrintSizes, PrintTurns} from '../../model/design/options.js';

/** An error of the user, described in one sentence; the exit code is 2. */
export class UsageError extends Error {
  override readonly name = 'UsageError';
}

/** Arguments of a subcommand: flags with a value, flags without, and files in order. */
interface Grammar {
  readonly valued: readonly string[];
  readonly switches: readonly string[];
  readonly files: readonly string[];
  /** Flags with a value that may be repeated. */
  readonly repeated?: readonly string[];
  /** Allows further files of the kind of the last one. */
  readonly hasMore?: true;
}

export interface Arguments {
  readonly files: readonly string[];
  /** The value of a flag, or undefined. */
  value(flag: string): string | undefined;
  /** All values of a flag that may be repeated. */
  values(flag: string): readonly string[];
  has(flag: string): boolean;
}

/** Names of flags without their dashes, as `parseArgs` takes them; repeated flags are reported. */
const optionsOf = (flags: readonly string[], type: 'string' | 'boolean') =>
  flags.map((flag) => [flag.slice(2), {type, multiple: true}] as const);

/**
 * Parses `--flag value`, `--flag=value` and files.
 * @throws {UsageError} with the invalid argument
 */
export function parseArguments(words: readonly string[], grammar: Grammar): Arguments {
  const {tokens} = parseArgs({
    args: [...words],
    options: Object.fromEntries([
      ...optionsOf(grammar.valued, 'string'),
      ...optionsOf(grammar.switches, 'boolean'),
    ]),
    allowPositionals: true,
    strict: false, // the errors of Node do not list the known flags
    tokens: true,
  });
  const values = new Map<string, readonly string[]>();
  const files: string[] = [];
  for (const token of tokens) {
    if (token.kind === 'positional') files.push(token.value);
    if (token.kind !== 'option') continue;
    const [flag = ''] = (words[token.index] ?? '').split('=');
    const known = values.get(flag) ?? [];
    if (known.length > 0 && !grammar.repeated?.includes(flag)) {
      throw new UsageError(`${flag} is given twice.`);
    }
    values.set(flag, [...known, checkedValue(flag, token.value, grammar)]);
  }
  const missing = grammar.files[files.length];
  if (missing !== undefined) throw new UsageError(`${missing} is missing.`);
  const extra = files[grammar.files.length];
  if (extra !== undefined && !grammar.hasMore)
    throw new UsageError(`'${extra}' is one argument too many.`);
  return {
    files,
    value: (flag) => values.get(flag)?.[0],
    values: (flag) => values.get(flag) ?? [],
    has: (flag) => values.has(flag),
  };
}

/** The value of a flag; that of a switch is empty. @throws {UsageError} for an invalid flag */
function checkedValue(
  flag: string,
  value: string | undefined,
  {valued, switches}: Grammar,
): string {
  if (switches.includes(flag)) {
    if (value !== undefined) throw new UsageError(`${flag} takes no value.`);
    return '';
  }
  if (!valued.includes(flag)) {
    const known = [...valued, ...switches].join(', ');
    throw new UsageError(`unknown flag '${flag}'; there are ${known}.`);
  }
  if (value === undefined || value === '' || value.startsWith('--')) {
    throw new UsageError(`${flag} needs a value.`);
  }
  return value;
}

/**
 * The flag's value, if it is one of `choices`.
 * @param other other values that the caller reads, for messages
 * @throws {UsageError} for any other value
 */
export function choice<T extends string>(
  args: Arguments,
  flag: string,
  choices: readonly T[],
  other?: string,
): T | undefined {
  const value = args.value(flag);
  if (value === undefined) return undefined;
  const found = choices.find((known) => known === value);
  if (found === undefined) {
    const or = other === undefined ? '' : `, or ${other}`;
    throw new UsageError(`${flag} is '${value}', but must be one of ${choices.join(', ')}${or}.`);
  }
  return found;
}

/**
 * The flag's value as a whole number in a range.
 * @throws {UsageError} for any other value
 */
export function wholeNumber(
  args: Arguments,
  flag: string,
  [least, most]: readonly [number, number] = [0, 0xffffffff],
): number | undefined {
  const value = args.value(flag);
  if (value === undefined) return undefined;
  if (!/^\d{1,10}$/.test(value) || Number(value) < least || Number(value) > most) {
    throw new UsageError(
      `${flag} is '${value}', but must be a whole number from ${least} to ${most}.`,
    );
  }
  return Number(value);
}

/**
 * The flag's value as a number in a range, or the word that it may be instead.
 * @throws {UsageError} for any other value
 */
export function factor<T extends string = never>(
  args: Arguments,
  flag: string,
  [least, most]: readonly [number, number],
  word?: T,
): number | T | undefined {
  const value = args.value(flag);
  if (value === undefined) return undefined;
  if (value === word) return word;
  if (!/^\d{1,6}(\.\d{1,6})?$/.test(value) || Number(value) < least || Number(value) > most) {
    const or = word === undefined ? '' : `, or ${word}`;
    throw new UsageError(
      `${flag} is '${value}', but must be a number from ${least} to ${most}${or}.`,
    );
  }
  return Number(value);
}

/** Separator of the ends of a range, and of the items of a list. */
const rangeMark = '..';
const listMark = ',';

/**
 * The flag's value as sizes of a print: one number, a list such as 0.9,1,1.1 or a range such as
 * 0.9..1.1.
 * @throws {UsageError} for any other value
 */
export function printSizes(
  args: Arguments,
  flag: string,
  [least, most]: readonly [number, number],
): PrintSizes | undefined {
  const value = args.value(flag);
  if (value === undefined) return undefined;
  const isRange = value.includes(rangeMark);
  const numbers = value
    .split(isRange ? rangeMark : listMark)
    .map((part) => (/^\d{1,2}(\.\d{1,6})?$/.test(part) ? Number(part) : NaN));
  const [from = NaN, to = NaN] = numbers;
  const isKnown = numbers.every((size) => size >= least && size <= most);
  if (!isKnown || (isRange && (numbers.length !== 2 || from > to))) {
    throw new UsageError(
      `${flag} is '${value}', but must be a number from ${least} to ${most}, a range such as 0.9..1.1, or a list such as 0.95,1,1.05.`,
    );
  }
  if (isRange) return {from, to};
  return numbers.length === 1 ? from : {sizes: numbers};
}

/**
 * The flag's value as turns of a print: one number, or a list such as 0,45,90. [degrees]
 * @throws {UsageError} for any other value
 */
export function printTurns(args: Arguments, flag: string, most: number): PrintTurns | undefined {
  const value = args.value(flag);
  if (value === undefined) return undefined;
  const turns = value
    .split(listMark)
    .map((part) => (/^-?\d{1,3}(\.\d{1,6})?$/.test(part) ? Number(part) : NaN));
  if (!turns.every((turn) => Math.abs(turn) <= most)) {
    throw new UsageError(
      `${flag} is '${value}', but must be degrees from -${most} to ${most}, or a list such as 0,45,90.`,
    );
  }
  const [only = 0] = turns;
  return turns.length === 1 ? only : {turns};
}

/**
 * The flag's value as a length from 0 to `most`. [cm]
 * @throws {UsageError} for any other value
 */
export function lengthCm(args: Arguments, flag: string, most: number): number | undefined {
  const value = args.value(flag);
  if (value === undefined) return undefined;
  if (!/^\d{1,6}(\.\d{1,6})?$/.test(value) || Number(value) > most) {
    throw new UsageError(
      `${flag} is '${value}', but must be a length from 0 to ${String(most)} cm.`,
    );
  }
  return Number(value);
}
