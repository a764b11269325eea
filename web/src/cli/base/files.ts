import {randomUUID} from 'node:crypto';
import {constants} from 'node:fs';
import {access, rename, rm, stat, writeFile} from 'node:fs/promises';
import {dirname, resolve} from 'node:path';

import {fileError} from '../../node/files.js';
import {UsageError} from './arguments.js';

/**
 * Checks that outputs have different paths, since they would overwrite each other.
 * @throws {UsageError} for equal paths
 */
export function checkDistinct(outputs: Readonly<Record<string, string | undefined>>): void {
  const given = Object.entries(outputs).flatMap(([flag, path]) =>
    path === undefined ? [] : [{flag, at: resolve(path)}],
  );
  for (const [k, {flag, at}] of given.entries()) {
    const same = given.slice(0, k).find((other) => other.at === at);
    if (same) throw new UsageError(`${same.flag} and ${flag} name the same file; name two.`);
  }
}

/**
 * Checks before a long solve that an output can be written and overwrites no input.
 * @throws {UsageError} if it cannot be written
 */
export async function checkWritable(path: string, inputs: readonly string[] = []): Promise<void> {
  const same = inputs.find((input) => resolve(input) === resolve(path));
  if (same !== undefined) {
    throw new UsageError(`${path} is read and would be overwritten; name another file to write.`);
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

/**
 * Writes a file atomically, safe even against power failure.
 * @throws {UsageError} with the file and the reason
 */
export async function writeWhole(path: string, content: string | Uint8Array): Promise<void> {
  const existing = await stat(path).catch(() => null);
  try {
    if (existing && !existing.isFile()) {
      await writeFile(path, content); // a pipe or a device cannot be replaced
      return;
    }
    if (existing === null) await checkFolder(path);
    const draft = `${path}.${randomUUID().slice(0, 8)}.tmp`;
    try {
      await writeFile(draft, content, {flush: true});
      await rename(draft, path);
    } finally {
      await rm(draft, {force: true});
    }
  } catch (error) {
    throw fileError(error, path, 'written');
  }
}
