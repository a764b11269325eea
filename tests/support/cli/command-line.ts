/** The command line: as users run it, or within the process of the tests, which starts nothing. */
import {spawn} from 'node:child_process';
import {fileURLToPath} from 'node:url';

import {vi} from 'vitest';

const built = new URL('../../../dist/cli/', import.meta.url);
const program = fileURLToPath(new URL('main.js', built));

interface Outcome {
  readonly code: number | null;
  readonly out: string;
  readonly err: string;
}

/** Runs the built program to its end, as a process. */
export function seamwiseProcess(...words: string[]): Promise<Outcome> {
  return new Promise((resolve, reject) => {
    const child = spawn(process.execPath, [program, ...words]);
    let [out, err] = ['', ''];
    child.stdout.on('data', (chunk: Buffer) => (out += chunk.toString()));
    child.stderr.on('data', (chunk: Buffer) => (err += chunk.toString()));
    child.on('error', reject);
    child.on('close', (code) => {
      resolve({code, out, err});
    });
  });
}

/** Collects what the process writes to a stream, until `end`. */
class Collected {
  text = '';
  readonly end: () => void;

  constructor(stream: NodeJS.WriteStream) {
    const spy = vi.spyOn(stream, 'write').mockImplementation((chunk) => {
      this.text += typeof chunk === 'string' ? chunk : Buffer.from(chunk).toString();
      return true;
    });
    this.end = () => {
      spy.mockRestore();
    };
  }
}

async function withinProcess(words: readonly string[]): Promise<Outcome> {
  const {run} = (await import(new URL('run.js', built).href)) as {
    readonly run: (words: readonly string[]) => Promise<void>;
  };
  const [out, err] = [new Collected(process.stdout), new Collected(process.stderr)];
  const earlier = process.exitCode;
  process.exitCode = 0;
  try {
    await run(words);
    return {code: process.exitCode, out: out.text, err: err.text};
  } finally {
    process.exitCode = earlier;
    for (const stream of [out, err]) stream.end();
  }
}

let last: Promise<unknown> = Promise.resolve();

/**
 * Runs the built program within this process, after earlier calls. The outcome is that of
 * `seamwiseProcess`; loaded scripts and compiled modules stay.
 */
export function seamwise(...words: string[]): Promise<Outcome> {
  const outcome = last.then(() => withinProcess(words));
  last = outcome.catch(() => undefined);
  return outcome;
}
