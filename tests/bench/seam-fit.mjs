// What random alignments of a result's pieces would score, with one symmetry of the print per seam.
import {apply, printElements} from '../../dist/model/wallpaper.js';
import {fitOf, onPrint} from '../../dist/picture/fit.js';

/** The mean over random alignments of `rest` of the seams' one-symmetry fit. [cm2] */
export function randomSeamFit(result, count = 60) {
  const random = linearCongruential(12345);
  const fit = seamFit(result);
  let sum = 0;
  for (let k = 0; k < count; k++)
    sum += fit(result.pieces.map(() => anywhere(result.print, random)));
  return sum / count;
}

function anywhere({w1, w2}, random) {
  const [u, v] = [random(), random()];
  const translation = [u * w1[0] + v * w2[0], u * w1[1] + v * w2[1]];
  return {angle: 2 * Math.PI * random(), translation};
}

/** Numerical Recipes' generator: the same alignments on every run. */
function linearCongruential(seed) {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

/** The fit of `rest` as a function of the alignments: the cheapest symmetry for each seam that counts. */
export function seamFit(result, outline = 'rest') {
  const elements = printElements(result.print);
  const {w1, w2} = result.print; // short: the sample prints' bases need no reduction
  const {seams} = fitOf(result, outline, result.search);
  const counted = result.seams.flatMap(({a, b}, number) => {
    const {counts, lengths} = seams[number];
    return counts ? [{a, b, from: middles(a), to: middles(b), lengths}] : [];
  });

  function middles({piece, vertices}) {
    const points = vertices.map((vertex) => result.pieces[piece][outline][vertex]);
    return points.slice(1).map(([x, y], k) => [(x + points[k][0]) / 2, (y + points[k][1]) / 2]);
  }

  return (alignments) => {
    let total = 0;
    for (const {a, b, from, to, lengths} of counted) {
      const x = from.map((point) => onPrint(alignments[a.piece], point));
      const y = to.map((point) => onPrint(alignments[b.piece], point));
      total += Math.min(...elements.map((element) => cheapest(element, x, y, lengths, [w1, w2])));
    }
    return total;
  };
}

/** Sum of length times distance of x to element(y), with the lattice shift near the mean that suits best. */
function cheapest(element, x, y, lengths, [a, b]) {
  const apart = y.map((point, k) => {
    const image = apply(element, point);
    return [x[k][0] - image[0], x[k][1] - image[1]];
  });
  const length = lengths.reduce((sum, l) => sum + l, 0);
  const mean = [0, 1].map(
    (axis) => apart.reduce((m, v, k) => m + v[axis] * lengths[k], 0) / length,
  );
  const area = a[0] * b[1] - a[1] * b[0];
  const s = Math.round((mean[0] * b[1] - mean[1] * b[0]) / area);
  const t = Math.round((a[0] * mean[1] - a[1] * mean[0]) / area);
  let least = Infinity;
  for (let i = s - 1; i <= s + 1; i++) {
    for (let j = t - 1; j <= t + 1; j++) {
      const shift = [i * a[0] + j * b[0], i * a[1] + j * b[1]];
      const cost = apart.reduce(
        (sum, v, k) => sum + lengths[k] * Math.hypot(v[0] - shift[0], v[1] - shift[1]),
        0,
      );
      least = Math.min(least, cost);
    }
  }
  return least;
}
