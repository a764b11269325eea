import {readGarment, seamSuggestions, type NamedEdge, type SeamSuggestions} from '../node/index.js';
import {readGarmentText} from './base/garment-text.js';
import {parseArguments, UsageError, wholeNumber} from './base/arguments.js';
import {print} from './base/terminal.js';

const grammar = {
  files: ['the garment file'],
  valued: ['--confirm', '--seed'],
  switches: ['--strip', '--suggest', '--json'],
};

/** `seams`: suggests partners for the edges of a garment by their shapes. */
export async function listSeams(words: readonly string[]): Promise<void> {
  const args = parseArguments(words, grammar);
  const [file = ''] = args.files;
  if (!args.has('--suggest')) throw new UsageError('--suggest is missing: it is what seams does.');
  const strip = args.has('--strip');
  const confirm = wholeNumber(args, '--confirm');
  const seed = wholeNumber(args, '--seed');
  const alone = confirm !== undefined ? '--confirm' : seed !== undefined ? '--seed' : undefined;
  if (!strip && alone !== undefined) {
    throw new UsageError(`${alone} says which seams --strip leaves; add --strip.`);
  }
  const text = await readGarmentText(file);
  const {seams} = await readGarment(text, file);
  if (confirm !== undefined && confirm > seams.length) {
    throw new UsageError(
      `--confirm is '${String(confirm)}', but there are ${String(seams.length)} seams in ${file}; name as many at most.`,
    );
  }
  const settings = {
    strip,
    ...(confirm !== undefined && {confirm}),
    ...(seed !== undefined && {seed}),
  };
  const found = await seamSuggestions(text, settings, file);
  print(args.has('--json') ? `${JSON.stringify(found)}\n` : listOf(found));
}

const called = ({piece, edge}: NamedEdge): string => `${piece} ${String(edge)}`;
const percent = (p: number): string => `${(100 * p).toFixed(0)} %`;

/** The certain seams, one per line, then the three likeliest partners of each edge. */
function listOf({edges, sure}: SeamSuggestions): string {
  const lines = [
    ...sure.map(({a, b, p}) => `sure: ${called(a)} - ${called(b)}, ${percent(p)}`),
    ...edges.map(({partners, ...edge}) => {
      const best = partners.slice(0, 3).map((one) => `${called(one)} (${percent(one.p)})`);
      return `${called(edge)}: ${best.join(', ')}`;
    }),
  ];
  return lines.map((line) => `${line}\n`).join('');
}
