/** Batches as in a shop: a folder with garments, prints and jobs, and the program run on it. */
import {spawn, type ChildProcess} from 'node:child_process';
import {mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {setTimeout as sleep} from 'node:timers/promises';
import {fileURLToPath} from 'node:url';

import {checks, twoStrips} from '../garments/samples.js';

const program = fileURLToPath(new URL('../../../dist/cli/main.js', import.meta.url));

interface Outcome {
  /** Null when a signal ended it. */
  readonly code: number | null;
  readonly out: string;
  readonly err: string;
}

/** A line of done.ndjson, with the fields that tests check. */
interface DoneLine {
  readonly key: string | null;
  readonly line?: number;
  readonly name?: string | null;
  readonly garment?: string;
  readonly print?: string;
  readonly size?: string | null;
  readonly status: 'done' | 'failed';
  readonly metrics?: {readonly fit: number; readonly seed: number};
  readonly failure?: {readonly code: string; readonly message: string};
  readonly milliseconds?: number | null;
  readonly sha256?: string;
  readonly file: string | null;
}

export type JobLine = Readonly<Record<string, unknown>>;

/** A started program, and its end. */
export interface Started {
  readonly child: ChildProcess;
  readonly end: Promise<Outcome>;
}

export class Shop {
  readonly folder = mkdtempSync(join(tmpdir(), 'seamwise-batch-'));

  /** Creates garments of two strips, 8 and 10 cm high, and a print that fits both. */
  constructor() {
    for (const height of [8, 10]) {
      this.write(`strips-${height}.json`, JSON.stringify(twoStrips(height)));
    }
    this.write('checks.json', JSON.stringify(checks));
    this.write('waves.json', JSON.stringify({...checks, group: 'p1'}));
  }

  at = (...names: string[]): string => join(this.folder, ...names);

  write(name: string, text: string): void {
    writeFileSync(this.at(name), text);
  }

  read = (...names: string[]): string => readFileSync(this.at(...names), 'utf8');

  /** Writes jobs as JSON lines; strings are written unchanged. */
  writeJobs(name: string, lines: readonly (JobLine | string)[]): void {
    const texts = lines.map((line) => (typeof line === 'string' ? line : JSON.stringify(line)));
    this.write(name, `${texts.join('\n')}\n`);
  }

  start(words: readonly string[], script = program): Started {
    const child = spawn(process.execPath, [script, ...words], {cwd: this.folder});
    let [out, err] = ['', ''];
    child.stdout.on('data', (chunk: Buffer) => (out += chunk.toString()));
    child.stderr.on('data', (chunk: Buffer) => (err += chunk.toString()));
    const end = new Promise<Outcome>((resolve, reject) => {
      child.on('error', reject);
      child.on('close', (code) => {
        resolve({code, out, err});
      });
    });
    return {child, end};
  }

  run(...words: string[]): Promise<Outcome> {
    return this.start(words).end;
  }

  /** Runs a batch on one thread, since most tests have few jobs for it. */
  batch(jobs: string, out: string, ...words: string[]): Promise<Outcome> {
    return this.batchOn(1, jobs, out, ...words);
  }

  batchOn(threads: number, jobs: string, out: string, ...words: string[]): Promise<Outcome> {
    return this.run('batch', jobs, '--out', out, '--workers', String(threads), ...words);
  }

  done(out: string): DoneLine[] {
    const lines = this.read(out, 'done.ndjson').split('\n');
    return lines.slice(0, -1).map((line) => JSON.parse(line) as DoneLine);
  }

  /** File names of the successful jobs' results. */
  results(out: string): string[] {
    return readdirSync(this.at(out, 'results')).sort();
  }

  /**
   * Everything that is the same in every run of a batch: its results, byte for byte, and its lines
   * without times.
   */
  truth(out: string): {readonly files: readonly string[]; readonly lines: readonly string[]} {
    const files = ['results', 'failures'].flatMap((kind) =>
      readdirSync(this.at(out, kind))
        .sort()
        .map((name) => `${name} ${this.read(out, kind, name)}`),
    );
    const lines = this.done(out).map((line) => JSON.stringify({...line, milliseconds: 0}));
    return {files, lines: lines.sort()};
  }

  remove(): void {
    rmSync(this.folder, {recursive: true, force: true});
  }
}

/**
 * Waits, polling every few milliseconds. Only the time limit of the test ends it.
 * @param by  program that has to fulfil the condition
 * @throws {Error} when that program ends before
 */
export async function until(isSo: () => boolean, by?: Started): Promise<void> {
  let outcome: Outcome | undefined;
  void by?.end.then((end) => (outcome = end));
  while (!isSo()) {
    if (outcome) throw new Error(`the program has ended: ${JSON.stringify(outcome)}`);
    await sleep(5);
  }
}

const shipped = new URL('../../../public/', import.meta.url).href;

/** A job that never ends: its thread works until it is stopped. */
export const endlessJob: JobLine = {
  garment: `${shipped}garments/patchwork-jacket-m.json`,
  print: `${shipped}prints/p1.json`,
  options: {proof: 1_000_000},
  name: 'endless',
};
