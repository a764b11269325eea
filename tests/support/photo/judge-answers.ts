/** Scores a folder of answers for a folder of cases, and counts the right ones by level. */
import {existsSync, readFileSync} from 'node:fs';
import {join} from 'node:path';

import type {Point} from '@/model/geometry/vectors.js';
import type {GroupName} from '@/model/print/repeating-print.js';

import type {CaseTruth} from './case.js';
import {decoded, fromRaw} from './files.js';
import {shapeOf, type Shape} from './group-elements.js';
import {basisFound, judge, latticePoint, type PhotoAnswer, type Verdict} from './judge.js';
import {sidesOf, tilePsnr} from './judge-tile.js';

interface Judged extends Verdict {
  /** Lattice shape of the group found, which leaves ratio or angle of the sides open. */
  readonly shape: Shape | undefined;
  /** Peak signal-to-noise ratio of the tile, if the answer has one. [dB] */
  readonly psnr: number | undefined;
}

interface PrintFile {
  readonly group: GroupName;
  readonly w1: Point;
  readonly w2: Point;
  readonly image: string;
  readonly cell: 'primitive' | 'rectangular';
}

/** Peak signal-to-noise ratio against the true cell. */
async function psnrOf(
  truth: CaseTruth,
  answer: PhotoAnswer,
  print: PrintFile,
  cases: string,
  answers: string,
): Promise<number | undefined> {
  if (truth.group === null) return undefined;
  const image = print.image.startsWith('data:')
    ? Buffer.from(print.image.slice(print.image.indexOf(',') + 1), 'base64')
    : readFileSync(join(answers, print.image));
  const [p, q, r, s] = basisFound(truth, answer);
  if (p * s - q * r !== 1) return undefined;
  const origin: Point = latticePoint(truth, answer.originPx);
  const cell = fromRaw(readFileSync(join(cases, `${truth.name}.cell.rgba`)));
  const sides = sidesOf(print.cell, shapeOf(print.group));
  return tilePsnr(cell, {pixels: await decoded(image), sides, basis: [p, q, r, s], origin});
}

const textIn = (file: string): string =>
  existsSync(file) ? readFileSync(file, 'utf8').trim() : '';

/**
 * @param answers  folder with NAME.json as printed by `photo --json`, missing if the image was
 * refused, and NAME.print.json, whose w1 and w2 are in proportion if the answer has none
 */
export async function judgeAnswers(cases: string, answers: string): Promise<readonly Judged[]> {
  const truths = JSON.parse(readFileSync(join(cases, 'cases.json'), 'utf8')) as CaseTruth[];
  const judged: Judged[] = [];
  for (const truth of truths) {
    const text = textIn(join(answers, `${truth.name}.json`));
    const answer = text === '' ? undefined : (JSON.parse(text) as PhotoAnswer);
    const printText = textIn(join(answers, `${truth.name}.print.json`));
    const print = printText === '' ? undefined : (JSON.parse(printText) as PrintFile);
    const psnr = answer && print && (await psnrOf(truth, answer, print, cases, answers));
    judged.push({...judge(truth, answer, print), shape: answer && shapeOf(answer.group), psnr});
  }
  return judged;
}

function quantile(values: readonly number[], share: number): number {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))] ?? NaN;
}

const spread = (values: readonly number[], unit: string): string =>
  values.length === 0
    ? 'not told'
    : `median ${quantile(values, 0.5).toFixed(3)}${unit}, worst ${quantile(values, 1).toFixed(2)}${unit}`;

const percent = (part: number, of: number): string =>
  of === 0 ? '-' : `${((100 * part) / of).toFixed(1)} %`;

/** One line per level: number and quality of the right answers. */
export function summaryOf(judged: readonly Judged[]): string {
  const levels = [...new Set(judged.map(({level}) => level))];
  return levels
    .flatMap((level) =>
      linesOf(
        level,
        judged.filter((one) => one.level === level),
      ),
    )
    .join('\n');
}

function linesOf(level: string, cases: readonly Judged[]): readonly string[] {
  // decoys and cut tiles contain no print
  const empty = cases.filter(({kind}) => level === 'decoy' || kind === 'cut');
  const claimed = empty.filter(({answered}) => answered === 'claimed');
  const full = cases.filter((one) => !empty.includes(one));
  const lines: string[] = [];
  if (empty.length > 0) {
    lines.push(
      `${level}: ${empty.length - claimed.length} of ${empty.length} without a print refused or uncertain` +
        (claimed.length > 0 ? `; claimed: ${claimed.map(({name}) => name).join(' ')}` : ''),
    );
  }
  if (full.length === 0) return lines;
  const prints = full.flatMap((one) => (one.print ? [{...one, print: one.print}] : []));
  const right = prints.filter(({print}) => print.primitive);
  const errors = right.map(({print}) => 100 * print.latticeError);
  const wrong = prints.filter(({print, answered}) => !print.primitive && answered === 'claimed');
  const exact = right.filter(({print}) => print.exactGroup);
  const falsely = prints.filter(
    ({print, answered}) => print.falseClaim && !print.near && answered === 'claimed',
  );
  // excludes values that the group determines, as they are not measured
  const aspects = right.flatMap(({shape, print: {aspectError}}) =>
    aspectError === undefined || !['oblique', 'rectangular'].includes(shape ?? '')
      ? []
      : [Math.abs(100 * aspectError)],
  );
  const angles = right.flatMap(({shape, print: {angleError}}) =>
    angleError === undefined || !['oblique', 'rhombic'].includes(shape ?? '')
      ? []
      : [Math.abs(angleError)],
  );
  const origins = exact.map(({print}) => 100 * print.originError);
  const tiles = prints.flatMap(({psnr}) => (psnr === undefined ? [] : [psnr]));
  lines.push(
    [
      `${level}: ${full.length} prints, ${prints.length} answered`,
      `lattice ${percent(right.length, full.length)}`,
      `error median ${quantile(errors, 0.5).toFixed(3)} %, worst ${quantile(errors, 1).toFixed(3)} %`,
      `silently wrong ${wrong.length}`,
      `exact group ${percent(exact.length, full.length)}`,
      `false claims ${falsely.length}`,
      `origin worst ${quantile(origins, 1).toFixed(2)} %`,
      `aspect of ${aspects.length} ${spread(aspects, ' %')}`,
      `angle of ${angles.length} ${spread(angles, ' degrees')}`,
      `tile median ${quantile(tiles, 0.5).toFixed(1)} dB, worst ${quantile(tiles, 0).toFixed(1)} dB`,
    ].join('; '),
  );
  const named = (what: string, of: readonly Judged[]): void => {
    if (of.length > 0) lines.push(`  ${what}: ${of.map(({name}) => name).join(' ')}`);
  };
  named(
    'refused',
    full.filter(({answered}) => answered === 'refused'),
  );
  named(
    'lattice wrong',
    prints.filter(({print}) => !print.primitive),
  );
  named(
    'group not exact',
    right.filter(({print}) => !print.exactGroup),
  );
  named('false claims', falsely);
  return lines;
}
