// Summaries of figures.

export function median(values) {
  const sorted = values.toSorted((a, b) => a - b);
  const half = sorted.length / 2;
  return Number.isInteger(half) ? (sorted[half - 1] + sorted[half]) / 2 : sorted[Math.floor(half)];
}

/** A mismatch below this counts as zero. [cm2] */
const nothing = 1e-3;

/** Quotient of two mismatches; null where both are zero. */
export function quotient(fit, other) {
  if (other > nothing) return fit / other;
  return fit <= nothing ? null : Infinity;
}

/** Exponent of a power law through points: the slope of a line through their logarithms. */
export function exponent(points) {
  const logs = points.map(([x, y]) => [Math.log(x), Math.log(y)]);
  const mean = (k) => logs.reduce((sum, point) => sum + point[k], 0) / logs.length;
  const [x0, y0] = [mean(0), mean(1)];
  const over = (f) => logs.reduce((sum, [x, y]) => sum + f(x - x0, y - y0), 0);
  return over((x, y) => x * y) / over((x) => x * x);
}
