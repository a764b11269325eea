/** Reads a file line by line, with bounded memory. */
import {createReadStream} from 'node:fs';

import {fileError} from '../../node/files.js';

/** Greatest line length, above that of a job with pins for every piece. [characters] */
const greatestLength = 1_000_000;

interface Line {
  /** Counted from 1. */
  readonly number: number;
  /** Undefined if the line is too long. */
  readonly text: string | undefined;
  /** True if the line ends in a line break. */
  readonly isWhole: boolean;
}

/**
 * The lines of a file.
 * @throws {FileError} if the file cannot be read
 */
export async function* linesOf(path: string): AsyncGenerator<Line> {
  let [number, rest, isTooLong] = [1, '', false];
  const end = (isWhole: boolean): Line => {
    const text = isTooLong ? undefined : number === 1 ? rest.replace(/^\ufeff/, '') : rest;
    const line = {number, text, isWhole};
    [number, rest, isTooLong] = [number + 1, '', false];
    return line;
  };
  const take = (part: string) => {
    if (rest.length + part.length > greatestLength) [rest, isTooLong] = ['', true];
    else if (!isTooLong) rest += part;
  };
  try {
    for await (const chunk of createReadStream(path, 'utf8') as AsyncIterable<string>) {
      const parts = chunk.split('\n');
      for (const part of parts.slice(0, -1)) {
        take(part);
        yield end(true);
      }
      take(parts.at(-1) ?? '');
    }
  } catch (error) {
    throw fileError(error, path, 'read');
  }
  if (rest !== '' || isTooLong) yield end(false);
}
