import type {Progress} from '../../model/design/solve-problem.js';

const words = {
  preparation: 'Preparing',
  alignment: 'Aligning',
  deformation: 'Deforming',
} as const;

/** A line on standard error that is redrawn in place; disabled if standard error is no terminal. */
export class StatusLine {
  #shown = '';

  write(line: string): void {
    if (!process.stderr.isTTY || line === this.#shown) return;
    this.#shown = line;
    process.stderr.write(`\r\u001b[K${line}`);
  }

  clear(): void {
    if (this.#shown !== '') process.stderr.write('\r\u001b[K');
    this.#shown = '';
  }
}

/** Progress of a solve. */
export class ProgressLine extends StatusLine {
  show({phase, fraction}: Progress): void {
    this.write(`${words[phase]}, ${String(Math.floor(100 * fraction))} %`);
  }
}

/** Prints a note, which is neither result nor error. */
export function remark(sentence: string): void {
  process.stderr.write(`note: ${sentence}\n`);
}

/** Prints advice about the result. */
export function advise(sentence: string): void {
  process.stderr.write(`${sentence}\n`);
}

export function print(text: string): void {
  process.stdout.write(text.endsWith('\n') ? text : `${text}\n`);
}
