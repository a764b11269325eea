/** The package as users get it: packed, and installed in an empty folder. */
import {execFile} from 'node:child_process';
import {mkdir, mkdtemp, readdir, readFile, rm, symlink} from 'node:fs/promises';
import {tmpdir} from 'node:os';
import {dirname, join, relative, sep} from 'node:path';
import {fileURLToPath} from 'node:url';
import {promisify} from 'node:util';

import {build, tarball} from '../../../web/setup/build.mjs';

const run = promisify(execFile);
const project = fileURLToPath(new URL('../../..', import.meta.url));

interface Manifest {
  readonly license: string;
  readonly exports: Readonly<Record<string, string | Readonly<Record<string, string>>>>;
  readonly bin: Readonly<Record<string, string>>;
  readonly dependencies: Readonly<Record<string, string>>;
}

/** A program's output, and its errors if it failed or did not end. */
interface Run {
  readonly output: string;
  readonly complaints: string;
}

export interface Packed {
  /** File written by `npm pack`. */
  readonly tarball: string;
  /** Folder in which the package is installed, with its dependencies, without the peers. */
  readonly folder: string;
  readonly manifest: Manifest;
  /** Every file by its path in the package, with slashes. */
  readonly files: ReadonlyMap<string, Buffer>;
  /**
   * Installs the package in another folder, with packages of the project that are not its
   * dependencies.
   */
  readonly installIn: (folder: string, others: readonly string[]) => Promise<void>;
  /** Runs a module in Node with the package installed. @throws when it fails, or does not end */
  readonly node: (source: string) => Promise<Run>;
  readonly remove: () => Promise<void>;
}

/** Installs the packed package. Dependencies are copied from the project, without a registry. */
export async function packed(): Promise<Packed> {
  const home = await mkdtemp(join(tmpdir(), 'seamwise-package-'));
  await build('tarball');
  const folder = await install(tarball, home);
  const manifest = JSON.parse(await readFile(join(folder, 'package.json'), 'utf8')) as Manifest;
  const installIn = async (other: string, others: readonly string[]): Promise<void> => {
    await install(tarball, other);
    await link(other, [...Object.keys(manifest.dependencies), ...others]);
  };
  await link(home, Object.keys(manifest.dependencies));
  return {
    tarball,
    folder,
    manifest,
    files: await filesIn(folder),
    installIn,
    node: async (source) => {
      const args = ['--input-type=module', '--eval', source];
      const end = await run(process.execPath, args, {cwd: home, timeout: 30_000});
      return {output: end.stdout, complaints: end.stderr};
    },
    remove: () => rm(home, {recursive: true}),
  };
}

/** @returns the package's folder */
async function install(tarball: string, home: string): Promise<string> {
  const folder = join(home, 'node_modules/seamwise');
  await mkdir(folder, {recursive: true});
  await run('tar', ['-xzf', tarball, '-C', folder, '--strip-components=1']);
  return folder;
}

async function link(home: string, names: readonly string[]): Promise<void> {
  for (const name of names) {
    const place = join(home, 'node_modules', name);
    await mkdir(dirname(place), {recursive: true});
    await symlink(join(project, 'node_modules', name), place, 'junction');
  }
}

async function filesIn(folder: string): Promise<ReadonlyMap<string, Buffer>> {
  const entries = await readdir(folder, {recursive: true, withFileTypes: true});
  const paths = entries.filter((one) => one.isFile()).map((one) => join(one.parentPath, one.name));
  return new Map(
    await Promise.all(
      paths.map(
        async (path) =>
          [relative(folder, path).split(sep).join('/'), await readFile(path)] as const,
      ),
    ),
  );
}
