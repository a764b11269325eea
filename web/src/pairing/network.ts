/**
 * Small networks that turn features into log odds: one hidden layer, and direct weights beside it.
 */

/** Packed network of `weights.ts`: its sizes, and its numbers as printable characters. */
export interface PackedNetwork {
  readonly inputs: number;
  readonly hidden: number;
  /**
   * Greatest absolute weights: of the hidden layer's rows, offsets and outputs, and of the direct
   * weights.
   */
  readonly greatest: readonly [rows: number, offsets: number, outputs: number, direct: number];
  readonly offset: number;
  readonly text: string;
}

export interface Network {
  readonly inputs: number;
  readonly hidden: number;
  /** Divisor of each feature. */
  readonly spreads: Float64Array;
  readonly direct: Float64Array;
  /** Row by row, one row for each hidden unit. */
  readonly rows: Float64Array;
  readonly offsets: Float64Array;
  readonly outputs: Float64Array;
  readonly offset: number;
}

/** Characters from `(` to `~` without the backslash encode the numbers from -42 to 42. */
const half = 42;

function digit(text: string, at: number): number {
  const code = text.charCodeAt(at);
  return code - 40 - (code > 92 ? 1 : 0) - half;
}

/** Unpacks a network. */
export function unpacked({inputs, hidden, greatest, offset, text}: PackedNetwork): Network {
  const [rowsMost, offsetsMost, outputsMost, directMost] = greatest;
  let at = 0;
  const next = (): number => digit(text, at++) / half;
  const fine = (): number => next() + next() / (2 * half + 1);
  const list = (count: number, one: () => number): Float64Array =>
    Float64Array.from({length: count}, one);
  const spreads = list(inputs, () => 2 ** (6 * next()));
  const direct = list(inputs, () => next() * directMost);
  const most = list(hidden, () => fine() * rowsMost);
  const offsets = list(hidden, () => fine() * offsetsMost);
  const outputs = list(hidden, () => fine() * outputsMost);
  const rows = list(inputs * hidden, () => next());
  for (let k = 0; k < rows.length; k++)
    rows[k] = (rows[k] ?? 0) * (most[Math.floor(k / inputs)] ?? 0);
  return {inputs, hidden, spreads, direct, rows, offsets, outputs, offset};
}

/** Returns the log odds that a pair with these features is sewn. */
export function logOdds(network: Network, features: readonly number[]): number {
  const {inputs, hidden, spreads, direct, rows, offsets, outputs} = network;
  let sum = network.offset;
  const scaled = new Float64Array(inputs);
  for (let k = 0; k < inputs; k++) {
    const one = (features[k] ?? 0) / (spreads[k] ?? 1);
    scaled[k] = one;
    sum += one * (direct[k] ?? 0);
  }
  for (let unit = 0; unit < hidden; unit++) {
    let inner = offsets[unit] ?? 0;
    const row = unit * inputs;
    for (let k = 0; k < inputs; k++) inner += (rows[row + k] ?? 0) * (scaled[k] ?? 0);
    if (inner > 0) sum += inner * (outputs[unit] ?? 0);
  }
  return sum;
}
