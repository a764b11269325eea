import {basename, dirname, extname, isAbsolute, join} from 'node:path';

import {groupNames, type Print} from '../model/print.js';
import type {SolveResult} from '../model/result.js';
import {drawResult} from '../picture/draw-result.js';
import {parseArguments, UsageError} from './arguments.js';
import {checkWritable, readBytes, readText, resultLimit, writeText} from './files.js';
import {print} from './terminal.js';

const grammar = {
  files: ['the result file'],
  valued: ['--print', '--out', '--title'],
  switches: [],
};

/** Kinds of image that every browser shows, by the file's extension. */
const imageTypes: Readonly<Record<string, string>> = {
  '.png': 'image/png',
  '.jpg': 'image/jpeg',
  '.jpeg': 'image/jpeg',
  '.webp': 'image/webp',
  '.gif': 'image/gif',
  '.avif': 'image/avif',
};

/** `draw`: a result on its print, before and after, as an SVG file that stands by itself. */
export async function draw(words: readonly string[]): Promise<void> {
  const args = parseArguments(words, grammar);
  const [resultFile = ''] = args.files;
  const printFile = args.value('--print');
  if (printFile === undefined) throw new UsageError('--print PRINT.json is missing.');
  const out = args.value('--out');
  const title = args.value('--title');
  const result = asResult(await readJson(resultFile, resultLimit), resultFile);
  const cloth = asPrint(await readJson(printFile), printFile);
  if (!sameRepeat(result.print, cloth)) {
    throw new UsageError(
      `${resultFile} was solved for another group or repeat than ${printFile}'s; draw it on the print it was solved with.`,
    );
  }
  if (out !== undefined) await checkWritable(out);
  const tile = await readTile(cloth, printFile);
  const picture = drawResult(
    result,
    {...cloth, ...(tile === undefined ? {} : {tile})},
    {title: title ?? basename(resultFile, extname(resultFile))},
  );
  if (out === undefined) print(picture);
  else await writeText(out, picture);
}

async function readJson(path: string, limit?: number): Promise<unknown> {
  const text = await readText(path, limit);
  if (text.trim() === '') throw new UsageError(`${path} is empty; choose another file.`);
  try {
    return JSON.parse(text) as unknown;
  } catch {
    throw new UsageError(`${path} is not JSON; save it again.`);
  }
}

const isObject = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null;

function asResult(value: unknown, path: string): SolveResult {
  const complete =
    isObject(value) &&
    value.format === 'seamwise-result/1' &&
    ['pieces', 'seams', 'symmetries'].every((field) => Array.isArray(value[field])) &&
    ['print', 'metrics'].every((field) => isObject(value[field]));
  if (!complete) throw new UsageError(
      `${path} is not a result file (seamwise-result/1); align a garment with --out to get one.`,
    );
  return value as unknown as SolveResult;
}

function asPrint(value: unknown, path: string): Print {
  const isVector = (vector: unknown) =>
    Array.isArray(vector) && vector.length === 2 && vector.every(Number.isFinite);
  const complete =
    isObject(value) &&
    groupNames.some((name) => name === value.group) &&
    isVector(value.w1) &&
    isVector(value.w2);
  if (!complete) throw new UsageError(`${path} is not a print file; give it the fields group, w1 and w2.`);
  return value as unknown as Print;
}

/** The solver corrects a lattice that is within rounding of its type, so equal means nearly so. */
function sameRepeat(one: SolveResult['print'], other: Print): boolean {
  const close = (key: 'w1' | 'w2') =>
    Math.hypot(one[key][0] - other[key][0], one[key][1] - other[key][1]) <
    1e-5 * Math.hypot(...other[key]);
  return one.group === other.group && close('w1') && close('w2');
}

/** The print's image as the picture takes it: SVG text, or a URL that holds all of its bytes. */
async function readTile({image}: Print, printFile: string): Promise<string | undefined> {
  if (image === undefined || /^(data|https?):/.test(image)) return image;
  const path = isAbsolute(image) ? image : join(dirname(printFile), image);
  const extension = extname(path).toLowerCase();
  if (extension === '.svg') return readText(path);
  const type = imageTypes[extension];
  if (type === undefined) {
    throw new UsageError(`${path}, the print's image, is none of svg, png, jpg, webp, gif, avif; convert it.`);
  }
  return `data:${type};base64,${(await readBytes(path)).toString('base64')}`;
}
