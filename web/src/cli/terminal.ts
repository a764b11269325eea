import type {Progress} from '../model/problem.js';

const words = {alignment: 'Aligning', deformation: 'Deforming'} as const;

/** One line of progress on standard error, drawn over and over; silent when that is no terminal. */
export class ProgressLine {
  #shown = '';

  show({phase, fraction}: Progress): void {
    if (!process.stderr.isTTY) return;
    const line = `${words[phase]}, ${String(Math.floor(100 * fraction))} %`;
    if (line === this.#shown) return;
    this.#shown = line;
    process.stderr.write(`\r\u001b[K${line}`);
  }

  clear(): void {
    if (this.#shown !== '') process.stderr.write('\r\u001b[K');
    this.#shown = '';
  }
}

/** Remarks that are neither result nor error. */
export function remark(sentence: string): void {
  process.stderr.write(`note: ${sentence}\n`);
}

export function print(text: string): void {
  process.stdout.write(text.endsWith('\n') ? text : `${text}\n`);
}
