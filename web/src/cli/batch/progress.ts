import {StatusLine} from '../base/terminal.js';
import {listedIn, type Tally} from './run.js';

/** Redraw interval. [ms] */
const drawEvery = 100;

/** Progress of a batch on standard error, if that is a terminal. */
export class BatchProgress extends StatusLine {
  readonly isShown = process.stderr.isTTY;
  readonly #started = performance.now();
  #jobs = 0;
  #drawn = 0;

  /**
   * Counts the jobs of a file.
   * @throws {FileError} if it cannot be read
   */
  async expect(jobsFile: string): Promise<void> {
    const jobs = listedIn(jobsFile);
    while (!(await jobs.next()).done) this.#jobs += 1;
  }

  show(tally: Readonly<Tally>): void {
    const now = performance.now();
    if (!this.isShown || now - this.#drawn < drawEvery) return;
    this.#drawn = now;
    this.write(progressText(tally, this.#jobs, (now - this.#started) / 1000));
  }
}

/**
 * The text of the progress line.
 * @param seconds time since the start of the run
 */
export function progressText(
  {done, failed, now}: Readonly<Tally>,
  jobs: number,
  seconds: number,
): string {
  const rate = now / Math.max(seconds, 1e-3);
  const ended = done + failed;
  return [
    `${ended} of ${jobs} jobs`,
    ...(failed > 0 ? [`${failed} failed`] : []),
    ...(now > 0 ? [`${rate.toFixed(1)} a second`, `${duration((jobs - ended) / rate)} left`] : []),
  ].join(', ');
}

function duration(seconds: number): string {
  const whole = Math.ceil(seconds);
  const [hours, minutes] = [Math.floor(whole / 3600), Math.floor((whole % 3600) / 60)];
  if (hours > 0) return `${hours} h ${minutes} min`;
  return minutes > 0 ? `${minutes} min ${whole % 60} s` : `${whole} s`;
}
