import {randomUUID} from 'node:crypto';
import {constants} from 'node:fs';
import {access, open, rename, rm, stat, writeFile, type FileHandle} from 'node:fs/promises';
import {dirname, resolve} from 'node:path';

import {UsageError} from './arguments.js';

/** Real garments stay below 1 MB. [bytes] */
export const inputLimit = 20_000_000;
/** A result holds every vertex twice. [bytes] */
export const resultLimit = 200_000_000;

/** The text of a file, which may be a pipe. @throws {UsageError} naming the file and what is wrong */
export async function readText(path: string, limit?: number): Promise<string> {
  // also drops the mark that some editors put before UTF-8
  return new TextDecoder().decode(await readBytes(path, limit));
}

/** The bytes of a file, which may be a pipe. @throws {UsageError} naming the file and what is wrong */
export async function readBytes(path: string, limit: number = inputLimit): Promise<Buffer> {
  const tooLarge = () =>
    new UsageError(
      `${path} is larger than ${String(limit / 1e6)} MB, the limit for such a file; choose another.`,
    );
  let file: FileHandle | undefined;
  try {
    file = await open(path, 'r');
    const {size} = await file.stat();
    if (size > limit) throw tooLarge();
    const chunks: Buffer[] = [];
    let length = 0;
    for await (const chunk of file.createReadStream({autoClose: false}) as AsyncIterable<Buffer>) {
      length += chunk.length;
      if (length > limit) throw tooLarge();
      chunks.push(chunk);
    }
    return Buffer.concat(chunks);
  } catch (error) {
    throw fileError(error, path, 'read');
  } finally {
    await file?.close();
  }
}

/**
 * Finds out before a long solve that its result could not be written, or would be written over what is read.
 * @throws {UsageError}
 */
export async function checkWritable(path: string, inputs: readonly string[] = []): Promise<void> {
  const same = inputs.find((input) => resolve(input) === resolve(path));
  if (same !== undefined) {
    throw new UsageError(`${path} is read and would be overwritten; name another file for --out.`);
  }
  try {
    const existing = await stat(path).catch(() => null);
    if (existing?.isDirectory()) throw new UsageError(`${path} is a directory; name a file in it.`);
    if (existing === null) await checkFolder(path);
    await access(existing ? path : dirname(path), constants.W_OK);
  } catch (error) {
    throw fileError(error, path, 'written');
  }
}

async function checkFolder(path: string): Promise<void> {
  const folder = dirname(path);
  const found = await stat(folder).catch((error: unknown) => {
    if (!(error instanceof Error && 'code' in error && error.code === 'ENOENT')) throw error;
    throw new UsageError(
      `${path} cannot be written: there is no folder ${folder}; create it, or choose another.`,
    );
  });
  if (!found.isDirectory()) {
    throw new UsageError(`${path} cannot be written: ${folder} is not a directory.`);
  }
}

/** Writes a file whole or not at all. @throws {UsageError} naming the file and what is wrong */
export async function writeText(path: string, text: string): Promise<void> {
  const existing = await stat(path).catch(() => null);
  try {
    if (existing && !existing.isFile()) {
      await writeFile(path, text); // a pipe or a device cannot be replaced
      return;
    }
    if (existing === null) await checkFolder(path);
    const draft = `${path}.${randomUUID().slice(0, 8)}.tmp`;
    try {
      await writeFile(draft, text);
      await rename(draft, path);
    } finally {
      await rm(draft, {force: true});
    }
  } catch (error) {
    throw fileError(error, path, 'written');
  }
}

const reasons: Readonly<Record<string, string>> = {
  ENOENT: 'there is no such file or directory',
  ENOTDIR: 'a part of the path is not a directory',
  EACCES: 'permission is denied',
  EPERM: 'permission is denied',
  EROFS: 'the file system is read-only',
  ENOSPC: 'the disk is full',
  ENAMETOOLONG: 'the name is too long',
  ELOOP: 'its links run in circles',
};

function fileError(error: unknown, path: string, verb: 'read' | 'written'): unknown {
  const code = error instanceof Error && 'code' in error ? String(error.code) : '';
  if (code === '') return error;
  if (code === 'EISDIR') return new UsageError(`${path} is a directory; name a file in it.`);
  return new UsageError(`${path} cannot be ${verb}: ${reasons[code] ?? code}.`);
}
