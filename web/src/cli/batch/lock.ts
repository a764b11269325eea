/** Locks a folder against other batches. */
import {randomUUID} from 'node:crypto';
import {link, readFile, rename, rm, writeFile} from 'node:fs/promises';
import {hostname} from 'node:os';

import {fieldOf} from '../../model/base/read.js';
import {UsageError} from '../base/arguments.js';

interface Owner {
  readonly host: string;
  readonly process: number;
}

/**
 * Locks a folder.
 * @returns a function that unlocks the folder
 * @throws {UsageError} if another batch uses the folder
 */
export async function lockFolder(folder: string): Promise<() => Promise<void>> {
  const file = `${folder}/batch.lock`;
  const own = `${file}.${randomUUID()}`;
  const words = JSON.stringify({host: hostname(), process: process.pid} satisfies Owner);
  await writeFile(own, words);
  try {
    while (!(await linked(own, file))) await removeStale(file, folder);
  } finally {
    await rm(own, {force: true});
  }
  return () => rm(file, {force: true});
}

/** Creates the lock atomically; returns false if there is one. */
async function linked(own: string, file: string): Promise<boolean> {
  try {
    await link(own, file);
    return true;
  } catch (error) {
    if (codeOf(error) === 'EEXIST') return false;
    throw error;
  }
}

async function removeStale(file: string, folder: string): Promise<void> {
  const aside = `${file}.${randomUUID()}`;
  try {
    const words = await readFile(file, 'utf8');
    const owner = ownerIn(words);
    if (owner === undefined) {
      throw new UsageError(
        `${file} is damaged; if no other batch is at work in ${folder}, remove that file.`,
      );
    }
    if (isAtWork(owner)) {
      throw new UsageError(
        `another batch, process ${owner.process} on ${owner.host}, is at work in ${folder}; wait for its end, or, if it has ended, remove ${file}.`,
      );
    }
    await rename(file, aside);
    // another process may have replaced the stale lock by its own
    if ((await readFile(aside, 'utf8')) !== words) await linked(aside, file);
  } catch (error) {
    if (codeOf(error) !== 'ENOENT') throw error;
  } finally {
    await rm(aside, {force: true});
  }
}

/** The owner of a lock; undefined if the lock is damaged. */
function ownerIn(words: string): Owner | undefined {
  try {
    const owner: unknown = JSON.parse(words);
    const [host, number] = [fieldOf(owner, 'host'), fieldOf(owner, 'process')];
    const isSound = typeof host === 'string' && Number.isSafeInteger(number);
    return isSound ? {host, process: Number(number)} : undefined;
  } catch {
    return undefined;
  }
}

/**
 * Owners on other hosts are assumed to run. In a restarted container, an ended process may have had
 * this process's number.
 */
function isAtWork(owner: Owner): boolean {
  if (owner.host !== hostname()) return true;
  if (owner.process === process.pid) return false;
  try {
    process.kill(owner.process, 0);
    return true;
  } catch (error) {
    return codeOf(error) !== 'ESRCH';
  }
}

const codeOf = (error: unknown): unknown =>
  error instanceof Error && 'code' in error ? error.code : undefined;
