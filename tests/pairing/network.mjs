// The networks of web/src/pairing: learning their weights, and packing them as network.ts unpacks
// them.

/** Random numbers from 0 to 1, the same for the same seed: Mulberry32. */
export function chance(seed) {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let mixed = Math.imul(state ^ (state >>> 15), 1 | state);
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed;
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32;
  };
}

/** Packable numbers: from -42 to 42, as characters from `(` to `~` without the backslash. */
const half = 42;
const digit = (whole) => String.fromCharCode(whole + half + 40 + (whole + half >= 52 ? 1 : 0));
const rounded = (share) => Math.max(-half, Math.min(half, Math.round(share * half)));
const most = (list) => list.reduce((top, one) => Math.max(top, Math.abs(one)), 1e-9);

/** Rows of features, each with its answer (seam or not) and its weight. */
export class Rows {
  #rows = [];
  #answers = [];
  #weights = [];

  add(features, isSeam, weight) {
    this.#rows.push(Float32Array.from(features));
    this.#answers.push(isSeam ? 1 : 0);
    this.#weights.push(weight);
  }

  get count() {
    return this.#rows.length;
  }

  /** The means of features, and their deviations in packable form. */
  #spread(inputs) {
    const means = new Float64Array(inputs);
    const spreads = new Float64Array(inputs);
    for (const row of this.#rows) for (let k = 0; k < inputs; k++) means[k] += row[k] / this.count;
    for (const row of this.#rows) {
      for (let k = 0; k < inputs; k++) spreads[k] += (row[k] - means[k]) ** 2 / this.count;
    }
    const packable = spreads.map(
      (one) => 2 ** ((6 / half) * rounded(Math.log2(Math.sqrt(one) + 1e-3) / 6)),
    );
    return {means, spreads: packable};
  }

  /** Learns the weights of a network by Adam, with a rate that falls along a cosine. */
  learn({hidden, epochs, seed, rate = 3e-3, decay = 1e-4}) {
    const inputs = this.#rows[0].length;
    const {means, spreads} = this.#spread(inputs);
    const random = chance(seed);
    const normal = () =>
      Math.sqrt(-2 * Math.log(random() + 1e-12)) * Math.cos(2 * Math.PI * random());
    const [offsets, outputs, direct] = [
      inputs * hidden,
      (inputs + 1) * hidden,
      (inputs + 2) * hidden,
    ];
    const last = direct + inputs;
    const weights = new Float64Array(last + 1);
    for (let k = 0; k < offsets; k++) weights[k] = normal() * Math.sqrt(1.5 / inputs);
    for (let k = 0; k < hidden; k++) weights[outputs + k] = normal() / Math.sqrt(hidden);
    const [slopes, first, second] = [0, 0, 0].map(() => new Float64Array(last + 1));
    const scaled = new Float64Array(inputs);
    const inner = new Float64Array(hidden);
    const order = Uint32Array.from(this.#rows, (_, k) => k);
    const batch = 256;
    const steps = epochs * Math.ceil(this.count / batch);
    const descend = (n) => {
      const row = this.#rows[n];
      let sum = weights[last];
      for (let k = 0; k < inputs; k++) {
        scaled[k] = (row[k] - means[k]) / spreads[k];
        sum += weights[direct + k] * scaled[k];
      }
      for (let unit = 0; unit < hidden; unit++) {
        let one = weights[offsets + unit];
        const at = unit * inputs;
        for (let k = 0; k < inputs; k++) one += weights[at + k] * scaled[k];
        inner[unit] = Math.max(0, one);
        sum += weights[outputs + unit] * inner[unit];
      }
      const slope = (1 / (1 + Math.exp(-sum)) - this.#answers[n]) * this.#weights[n];
      slopes[last] += slope;
      for (let k = 0; k < inputs; k++) slopes[direct + k] += slope * scaled[k];
      for (let unit = 0; unit < hidden; unit++) {
        if (inner[unit] === 0) continue;
        slopes[outputs + unit] += slope * inner[unit];
        const own = slope * weights[outputs + unit];
        slopes[offsets + unit] += own;
        const at = unit * inputs;
        for (let k = 0; k < inputs; k++) slopes[at + k] += own * scaled[k];
      }
    };
    let step = 0;
    for (let epoch = 0; epoch < epochs; epoch++) {
      for (let k = order.length - 1; k > 0; k--) {
        const other = Math.floor(random() * (k + 1));
        [order[k], order[other]] = [order[other], order[k]];
      }
      for (let from = 0; from < order.length; from += batch) {
        const some = order.subarray(from, from + batch);
        slopes.fill(0);
        for (const n of some) descend(n);
        step++;
        const now =
          rate * Math.min(1, step / 200) * (0.5 + 0.5 * Math.cos((Math.PI * step) / steps));
        for (let k = 0; k < weights.length; k++) {
          const slope = slopes[k] / some.length + decay * weights[k];
          first[k] = 0.9 * first[k] + 0.1 * slope;
          second[k] = 0.999 * second[k] + 0.001 * slope * slope;
          const mean = first[k] / (1 - 0.9 ** step);
          weights[k] -= (now * mean) / (Math.sqrt(second[k] / (1 - 0.999 ** step)) + 1e-8);
        }
      }
    }
    const part = (from, to) => weights.slice(from, to);
    return packed({
      ...{inputs, hidden, spreads},
      shifts: means.map((mean, k) => mean / spreads[k]),
      ...{rows: part(0, offsets), offsets: part(offsets, outputs), outputs: part(outputs, direct)},
      ...{direct: part(direct, last), offset: weights[last]},
    });
  }
}

/** Packs a network as text; the offsets absorb the centres of the features. */
function packed({inputs, hidden, spreads, shifts, rows, offsets, outputs, direct, offset}) {
  const directMost = most(direct);
  const directDigits = [...direct].map((one) => rounded(one / directMost));
  let offsetPacked = offset;
  for (const [k, one] of directDigits.entries())
    offsetPacked -= (one / half) * directMost * shifts[k];
  const tops = Array.from({length: hidden}, (_, unit) =>
    most(rows.slice(unit * inputs, (unit + 1) * inputs)),
  );
  const topMost = most(tops);
  const [topText, topsPacked] = fine(tops, topMost);
  const digits = [...rows].map((one, k) => rounded(one / topsPacked[Math.floor(k / inputs)]));
  const centred = [...offsets].map((one, unit) => {
    const row = digits.slice(unit * inputs, (unit + 1) * inputs);
    return row.reduce(
      (sum, weight, k) => sum - (weight / half) * topsPacked[unit] * shifts[k],
      one,
    );
  });
  const [offsetsMost, outputsMost] = [most(centred), most(outputs)];
  const text = [
    [...spreads].map((one) => digit(rounded(Math.log2(one) / 6))).join(''),
    directDigits.map(digit).join(''),
    topText,
    fine(centred, offsetsMost)[0],
    fine([...outputs], outputsMost)[0],
    digits.map(digit).join(''),
  ].join('');
  return {
    ...{inputs, hidden},
    greatest: [topMost, offsetsMost, outputsMost, directMost],
    ...{offset: offsetPacked, text},
  };
}

/** Packs numbers as two characters each, and returns their rounded values, too. */
function fine(list, top) {
  const pairs = list.map((one) => {
    const coarse = rounded(one / top);
    return [coarse, rounded((one / top - coarse / half) * (2 * half + 1))];
  });
  return [
    pairs.map(([coarse, rest]) => digit(coarse) + digit(rest)).join(''),
    pairs.map(([coarse, rest]) => top * (coarse / half + rest / half / (2 * half + 1))),
  ];
}
