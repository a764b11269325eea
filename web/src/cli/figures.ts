import type {SolveResult} from '../model/result.js';

/** How good the placing is that the search found, before anything was deformed. */
function proof(bound: number): string {
  if (bound === 1) return 'placing proven best';
  const above = 100 * (1 / bound - 1);
  return bound > 0.1
    ? `placing at most ${above.toFixed(above < 10 ? 1 : 0)} % above the least`
    : 'placing not improved further';
}

/** The figures of a result as one line for people. */
export function figuresLine(name: string, {print, pieces, seams, metrics}: SolveResult): string {
  const share = (fit: number) =>
    metrics.fitRandom > 0 ? ` (${((100 * fit) / metrics.fitRandom).toFixed(1)} %)` : '';
  return [
    `${name}: ${String(pieces.length)} pieces, ${String(seams.length)} seams, ${print.group}, ${metrics.method}, seed ${String(metrics.seed)}`,
    `mismatch random ${metrics.fitRandom.toFixed(1)} cm2`,
    `aligned ${metrics.fitAligned.toFixed(1)}${share(metrics.fitAligned)}`,
    ...(metrics.method === 'best' ? [proof(metrics.searchBound)] : []),
    `deformed ${metrics.fit.toFixed(1)}${share(metrics.fit)}`,
    `moved at most ${metrics.maxMovedCm.toFixed(2)} cm`,
    `${String(metrics.iterations)} iterations`,
    `${String(metrics.milliseconds.total)} ms`,
  ].join('; ');
}
