// What is told of the figures of one garment on one print, and of all of them together.

/** A fit below this is none at all. [cm2] */
const nothing = 1e-3;

/** The quotients that count, the columns they fill, and how small their medians are meant to be. */
export const goals = [
  {key: 'fit', title: 'fit best/paper', goal: 0.5},
  {key: 'time', title: 'time best/paper', goal: 0.1},
  {key: 'random', title: 'fit/random', goal: 0.1},
  {key: 'seamRandom', title: 'seam fit/random', goal: 0.1},
];

export function median(values) {
  const sorted = values.toSorted((a, b) => a - b);
  const half = sorted.length / 2;
  return Number.isInteger(half) ? (sorted[half - 1] + sorted[half]) / 2 : sorted[Math.floor(half)];
}

/** The medians over the seeds, and their quotients: '=' where both methods leave no mismatch at all. */
export function compare(runs) {
  const over = (figure) => median(runs.map(figure));
  const best = {
    fit: over((run) => run.best.fit),
    fitSeam: over((run) => run.best.fitSeam),
    milliseconds: over((run) => run.best.milliseconds.total),
  };
  const paper = {
    fit: over((run) => run.paper.fit),
    fitSeam: over((run) => run.paper.fitSeam),
    milliseconds: over((run) => run.paper.milliseconds.total),
  };
  const fitRandom = over((run) => run.fitRandom);
  const fitSeamRandom = over((run) => run.fitSeamRandom);
  return {
    best,
    paper,
    fitRandom,
    fitSeamRandom,
    ratios: {
      fit: quotient(best.fit, paper.fit),
      time: best.milliseconds / Math.max(paper.milliseconds, 1),
      random: quotient(best.fit, fitRandom),
      seamRandom: quotient(best.fitSeam, fitSeamRandom),
    },
  };
}

function quotient(fit, other) {
  if (other > nothing) return fit / other;
  return fit <= nothing ? '=' : Infinity;
}

/** Median and worst of every quotient, over the comparisons in which it is a number. */
export function summarise(comparisons) {
  return goals.map(({key, title, goal}) => {
    const numbers = comparisons.filter(({ratios}) => ratios[key] !== '=');
    const worst = numbers.toSorted((a, b) => b.ratios[key] - a.ratios[key])[0];
    const middle = numbers.length > 0 ? median(numbers.map(({ratios}) => ratios[key])) : 0;
    return {
      title,
      goal,
      median: middle,
      met: middle <= goal,
      worst: worst && {
        garment: worst.garment,
        group: worst.group,
        value: worst.ratios[key],
      },
      above: numbers.filter(({ratios}) => ratios[key] > goal).length,
      compared: numbers.length,
      equal: comparisons.length - numbers.length,
    };
  });
}
