/** Letters beyond Latin, Greek and Cyrillic for PDF files: given fonts, then Kosugi for Japanese. */
import {readFile} from 'node:fs/promises';
import {createRequire} from 'node:module';

import type {NamedFont, OtherLetters} from '../files/pdf/fonts/other-letters.js';
import {readTrueType} from '../files/pdf/fonts/true-type.js';

const pathOf = createRequire(import.meta.url).resolve;

/** A part of the font, with the code points of its letters. */
interface Slice {
  readonly file: string;
  readonly ranges: readonly (readonly [first: number, last: number])[];
}

let slices: Promise<readonly Slice[]> | undefined;
const known = new Map<string, Promise<NamedFont>>();

async function readSlices(): Promise<readonly Slice[]> {
  const text = await readFile(pathOf('@fontsource/kosugi/unicode.json'), 'utf8');
  return Object.entries(JSON.parse(text) as Record<string, string>).map(([name, ranges]) => ({
    file: `@fontsource/kosugi/files/kosugi-${name.replaceAll(/[[\]]/g, '')}-400-normal.woff`,
    ranges: ranges.split(',').map((range) => {
      const [first = '', last = first] = range.replace('U+', '').split('-');
      return [parseInt(first, 16), parseInt(last, 16)];
    }),
  }));
}

async function readFont(path: string, called: string, name: string): Promise<NamedFont> {
  const bytes = new Uint8Array(await readFile(path));
  return {name, font: await readTrueType(bytes, called)};
}

async function kosugiFor(code: number): Promise<NamedFont | undefined> {
  slices ??= readSlices();
  const slice = (await slices).find(({ranges}) =>
    ranges.some(([first, last]) => code >= first && code <= last),
  );
  if (!slice) return undefined;
  const {file} = slice;
  const font = known.get(file) ?? readFont(pathOf(file), file, 'Kosugi');
  known.set(file, font);
  return font;
}

const has = ({font}: NamedFont, code: number): boolean => font.glyphOf(code) > 0;

/**
 * Letters from fonts, and from the package's own ones.
 * @param files TTF or WOFF files with TrueType outlines, by preference
 * @throws {FileError} from `fontFor`, for other files
 */
export function lettersFrom(files: readonly Uint8Array<ArrayBuffer>[] = []): OtherLetters {
  let given: Promise<readonly NamedFont[]> | undefined;
  const readGiven = (): Promise<readonly NamedFont[]> =>
    Promise.all(
      files.map(async (bytes, k) => {
        const called = files.length > 1 ? `font ${k + 1}` : 'the font';
        return {name: `Font${k + 1}`, font: await readTrueType(bytes, called)};
      }),
    );
  return {
    fontFor: async (letter) => {
      const code = letter.codePointAt(0) ?? 0;
      given ??= readGiven();
      const own = (await given).find((font) => has(font, code));
      if (own) return own;
      const font = await kosugiFor(code);
      return font && has(font, code) ? font : undefined;
    },
  };
}
