/** Reads local files, and describes errors of the file system. */
import {closeSync, constants, openSync} from 'node:fs';
import {open, stat, type FileHandle} from 'node:fs/promises';
import {Socket} from 'node:net';

import {FileError} from '../model/base/versioned-file.js';

/** Greatest size of an input file; real garments are below 1 MB. [bytes] */
export const inputLimit = 20_000_000;
/** Greatest size of a result file, which contains every vertex twice. [bytes] */
export const resultLimit = 200_000_000;

/**
 * The text of a file or pipe.
 * @throws {FileError} with the file and the reason
 */
export const readText = async (path: string, limit?: number): Promise<string> =>
  textOf(await readBytes(path, limit));

/** The message for a file beyond a limit. [bytes] */
export const tooLarge = (limit: number): string =>
  `is larger than ${limit / 1e6} MB, the limit for such a file; choose another.`;

/** Decodes UTF-8, and drops the byte order mark of some editors. */
export const textOf = (bytes: Uint8Array): string => new TextDecoder().decode(bytes);

/**
 * The bytes of a file or pipe.
 * @throws {FileError} with the file and the reason; the signal's reason when it aborts
 */
export async function readBytes(
  path: string,
  limit: number = inputLimit,
  signal?: AbortSignal,
): Promise<Buffer> {
  const whole = async (stream: AsyncIterable<Buffer>): Promise<Buffer> => {
    const chunks: Buffer[] = [];
    let length = 0;
    for await (const chunk of stream) {
      length += chunk.length;
      if (length > limit) throw new FileError(path, tooLarge(limit));
      chunks.push(chunk);
    }
    return Buffer.concat(chunks);
  };
  let file: FileHandle | undefined;
  try {
    if ((await stat(path)).isFIFO()) return await whole(pipeAt(path, signal));
    file = await open(path, 'r');
    const {size} = await file.stat();
    if (size > limit) throw new FileError(path, tooLarge(limit));
    return await whole(file.createReadStream({autoClose: false}) as AsyncIterable<Buffer>);
  } catch (error) {
    signal?.throwIfAborted();
    throw fileError(error, path, 'read');
  } finally {
    await file?.close();
  }
}

/**
 * Opens a pipe without blocking: otherwise, a pipe without a writer would block a thread of Node
 * forever, and no signal could end it.
 */
function pipeAt(path: string, signal: AbortSignal | undefined): AsyncIterable<Buffer> {
  const fd = openSync(path, constants.O_RDONLY | constants.O_NONBLOCK);
  try {
    return new Socket({fd, readable: true, writable: false, ...(signal && {signal})});
  } catch (error) {
    closeSync(fd);
    throw error;
  }
}

const reasons: Readonly<Record<string, string>> = {
  ENOENT: 'there is no such file or directory',
  EEXIST: 'a file is where the folder belongs; move it, or name another folder',
  ENOTDIR: 'a part of the path is not a directory',
  EACCES: 'permission is denied',
  EPERM: 'permission is denied',
  EROFS: 'the file system is read-only',
  ENOSPC: 'the disk is full',
  ENAMETOOLONG: 'the name is too long',
  ELOOP: 'its links run in circles',
};

/** Converts an error of the file system to a sentence; other errors are unchanged. */
export function fileError(error: unknown, path: string, verb: 'read' | 'written'): unknown {
  const code = error instanceof Error && 'code' in error ? String(error.code) : '';
  if (code === '') return error;
  if (code === 'EISDIR') return new FileError(path, 'is a directory; name a file in it.');
  return new FileError(path, `cannot be ${verb}: ${reasons[code] ?? code}.`);
}
