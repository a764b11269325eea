// What figures are summed up by.

export function median(values) {
  const sorted = values.toSorted((a, b) => a - b);
  const half = sorted.length / 2;
  return Number.isInteger(half) ? (sorted[half - 1] + sorted[half]) / 2 : sorted[Math.floor(half)];
}

/** A fit below this is none at all. [cm2] */
const nothing = 1e-3;

/** Of two fits; null where neither leaves any mismatch. */
export function quotient(fit, other) {
  if (other > nothing) return fit / other;
  return fit <= nothing ? null : Infinity;
}

/** The slope of a line through the logarithms of points: y grows like x to this power. */
export function exponent(points) {
  const logs = points.map(([x, y]) => [Math.log(x), Math.log(y)]);
  const mean = (k) => logs.reduce((sum, point) => sum + point[k], 0) / logs.length;
  const [x0, y0] = [mean(0), mean(1)];
  const over = (f) => logs.reduce((sum, [x, y]) => sum + f(x - x0, y - y0), 0);
  return over((x, y) => x * y) / over((x) => x * x);
}
