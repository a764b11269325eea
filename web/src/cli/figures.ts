import type {SolveResult} from '../model/result.js';

/** The figures of a result as one line for people. */
export function figuresLine(name: string, {print, pieces, seams, metrics}: SolveResult): string {
  const share = (fit: number) =>
    metrics.fitRandom > 0 ? ` (${((100 * fit) / metrics.fitRandom).toFixed(1)} %)` : '';
  return [
    `${name}: ${String(pieces.length)} pieces, ${String(seams.length)} seams, ${print.group}, ${metrics.method}, seed ${String(metrics.seed)}`,
    `mismatch random ${metrics.fitRandom.toFixed(1)} cm2`,
    `aligned ${metrics.fitAligned.toFixed(1)}${share(metrics.fitAligned)}`,
    `deformed ${metrics.fit.toFixed(1)}${share(metrics.fit)}`,
    `moved at most ${metrics.maxMovedCm.toFixed(2)} cm`,
    `${String(metrics.iterations)} iterations`,
    `${String(metrics.milliseconds.total)} ms`,
  ].join('; ');
}
