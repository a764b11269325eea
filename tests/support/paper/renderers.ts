/** Renders pages with the programs that are installed. */
import {execFileSync} from 'node:child_process';
import {mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';

import {decoded, type Pixels} from '@samples/prints/raster.js';

/** Renders pages, numbered from 0. */
export type Renderer = (
  bytes: Uint8Array,
  pages: readonly number[],
  dpi: number,
) => Promise<readonly Pixels[]>;

/** Arguments for one page, numbered from 1, that write a PNG in the folder of the file. */
type Arguments = (file: string, out: string, page: number, dpi: number) => readonly string[];

const poppler: Arguments = (file, out, page, dpi) => [
  ...['-png', '-r', String(dpi), '-f', String(page), '-l', String(page), file, out],
];

/** Programs of Debian's packages poppler-utils and mupdf-tools. */
const programs: Readonly<Record<string, Arguments>> = {
  pdftoppm: poppler,
  pdftocairo: poppler,
  mutool: (file, out, page, dpi) => [
    ...['draw', '-q', '-r', String(dpi), '-o', `${out}.png`, file, String(page)],
  ],
};

const isInstalled = (program: string): boolean => {
  try {
    execFileSync('which', [program], {stdio: 'ignore'});
    return true;
  } catch {
    return false;
  }
};

const rendererOf =
  (program: string, argumentsOf: Arguments): Renderer =>
  async (bytes, pages, dpi) => {
    const folder = mkdtempSync(join(tmpdir(), 'seamwise-'));
    try {
      const file = join(folder, 'file.pdf');
      writeFileSync(file, bytes);
      const found: Pixels[] = [];
      for (const page of pages) {
        const name = `page${page}x`;
        execFileSync(program, [...argumentsOf(file, join(folder, name), page + 1, dpi)], {
          stdio: 'ignore',
        });
        const png = readdirSync(folder).find((one) => one.startsWith(name)) ?? name;
        found.push(await decoded(readFileSync(join(folder, png))));
      }
      return found;
    } finally {
      rmSync(folder, {recursive: true});
    }
  };

/** The programs that are installed. */
export const installed: Readonly<Record<string, Renderer>> = Object.fromEntries(
  Object.entries(programs)
    .filter(([program]) => isInstalled(program))
    .map(([program, argumentsOf]) => [program, rendererOf(program, argumentsOf)]),
);
