/** Contents of docs/embedding.md, for comparison with the code. */
import {readFileSync} from 'node:fs';

const text = readFileSync(new URL('../../../docs/embedding.md', import.meta.url), 'utf8');

/** The text under a heading, up to the next one. */
export const textOf = (heading: string): string =>
  text.split(/^##+ /m).find((part) => part.startsWith(`${heading}\n`)) ?? '';

/** Rows of the tables whose first column has this title, without their backticks. */
export function rowsOf(column: string): readonly (readonly string[])[] {
  const tables = text.matchAll(/(?:^\|.*\|\n)+/gm);
  const rows = [...tables].map(([table]) => table.trim().split('\n').map(cellsOf));
  return rows.filter(([head]) => head?.[0] === column).flatMap((all) => all.slice(2));
}

const cellsOf = (row: string): string[] =>
  row
    .slice(1, -1)
    .split('|')
    .map((cell) => cell.trim().replaceAll('`', ''));

/** The code examples in a language, in their order. */
export const snippetsIn = (language: string): readonly string[] =>
  [...text.matchAll(new RegExp(`^\`\`\`${language}\\n([^]*?)^\`\`\`$`, 'gm'))].map(
    ([, code = '']) => code,
  );

/**
 * The one code example in a language that contains these words. @throws {Error} when there is none,
 * or several
 */
export function snippetWith(language: string, words: string): string {
  const [code, ...more] = snippetsIn(language).filter((snippet) => snippet.includes(words));
  if (code === undefined || more.length > 0) {
    throw new Error(`docs/embedding.md has not one ${language} snippet with '${words}'.`);
  }
  return code;
}
