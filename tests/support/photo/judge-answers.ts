/** Judges a folder of answers to a folder of cases, and says how many are right, by level. */
import {existsSync, readFileSync} from 'node:fs';
import {dirname, join} from 'node:path';

import type {Point} from '@/model/geometry.js';
import type {GroupName} from '@/model/print.js';

import type {CaseTruth} from './case.js';
import {decoded, fromRaw} from './files.js';
import {shapeOf} from './group-elements.js';
import {basisFound, judge, latticePoint, type PhotoAnswer, type Verdict} from './judge.js';
import {sidesOf, tilePsnr} from './judge-tile.js';

interface Judged extends Verdict {
  /** Of the tile, where the answer has one. [dB] */
  readonly psnr: number | undefined;
}

interface PrintFile {
  readonly group: GroupName;
  readonly image: string;
  readonly cell: 'primitive' | 'rectangular';
}

/** The print NAME.print.json beside the answer, against the true cell. */
async function psnrOf(
  truth: CaseTruth,
  answer: PhotoAnswer | undefined,
  cases: string,
  answers: string,
): Promise<number | undefined> {
  const file = join(answers, `${truth.name}.print.json`);
  if (truth.group === null || !answer || !existsSync(file)) return undefined;
  const print = JSON.parse(readFileSync(file, 'utf8')) as PrintFile;
  const image = print.image.startsWith('data:')
    ? Buffer.from(print.image.slice(print.image.indexOf(',') + 1), 'base64')
    : readFileSync(join(dirname(file), print.image));
  const [p, q, r, s] = basisFound(truth, answer);
  if (p * s - q * r !== 1) return undefined;
  const origin: Point = latticePoint(truth, answer.originPx);
  const cell = fromRaw(readFileSync(join(cases, `${truth.name}.cell.rgba`)));
  const sides = sidesOf(print.cell, shapeOf(print.group));
  return tilePsnr(cell, {pixels: await decoded(image), sides, basis: [p, q, r, s], origin});
}

/** @param answers with NAME.json as printed by `photo --json`, none where the picture was refused */
export async function judgeAnswers(cases: string, answers: string): Promise<readonly Judged[]> {
  const truths = JSON.parse(readFileSync(join(cases, 'cases.json'), 'utf8')) as CaseTruth[];
  const judged: Judged[] = [];
  for (const truth of truths) {
    const file = join(answers, `${truth.name}.json`);
    const text = existsSync(file) ? readFileSync(file, 'utf8').trim() : '';
    const answer = text === '' ? undefined : (JSON.parse(text) as PhotoAnswer);
    const psnr = await psnrOf(truth, answer, cases, answers);
    judged.push({...judge(truth, answer), psnr});
  }
  return judged;
}

function quantile(values: readonly number[], share: number): number {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))] ?? NaN;
}

const percent = (part: number, of: number): string =>
  of === 0 ? '-' : `${((100 * part) / of).toFixed(1)} %`;

/** One line per level: what was found, and how well. */
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
  // decoys and cut tiles have nothing to be found
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
  const aspects = right.flatMap(({print}) =>
    print.aspectError === undefined ? [] : [Math.abs(100 * print.aspectError)],
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
      `aspect worst ${quantile(aspects, 1).toFixed(2)} %`,
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
