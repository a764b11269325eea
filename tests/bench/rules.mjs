// Rules that every result keeps, measured over many results from their geometry alone.
import {readdirSync, readFileSync} from 'node:fs';
import {cpus} from 'node:os';
import {basename, join} from 'node:path';

import {root} from '../../web/setup/shell.mjs';

/** Limits for seams in cm and shares, from docs/life-of-a-print.md. */
const limits = {worse: 0.03, met: 0.1, seen: 0.3, lost: 0.5, broken: 1, bent: 0.1, slip: 1e-6};
/** Greatest share of a bent seam's mismatch that remains, and the same while it looks broken. */
const gained = {met: 0.85, broken: 0.5};
/** Least visibility of a seam that is seen at first sight. */
const visible = 1.5;
const grains = ['on', 'free'];

/**
 * Measures every sample garment, or those of `--garments`, in every sample print, on grain and at
 * any angle.
 * @returns a row for each garment and grain: cases, seams, and the number that breaks each rule
 */
export async function measureRules({garments, thorough, say, fail}) {
  const {solve} = await import('../../dist/node/index.js');
  const {mismatchOf} = await import('../../dist/scene/mismatch.js');
  const prints = readdirSync(join(root, 'public/prints'))
    .filter((name) => name.endsWith('.json'))
    .map((name) => readFileSync(join(root, 'public/prints', name), 'utf8'));
  const files = thorough ? garments.flatMap(allSizes) : garments;
  const rows = [];
  for (const {file, name} of files) {
    const garment = readFileSync(file, 'utf8');
    for (const grain of grains) {
      say(`rules: ${name}, ${grain}`);
      const row = {garment: name, grain, cases: 0, seams: 0, worse: 0, vain: 0, whole: 0};
      rows.push({...row, drafted: 0, placed: 0, final: 0});
      const into = rows.at(-1);
      const left = prints.values();
      const work = async () => {
        for (const print of left) {
          try {
            const problem = {garment, print, options: {grain: {default: grain}}};
            judge(await solve(problem), mismatchOf, into);
          } catch (error) {
            fail(`rules: ${name}, ${grain}: ${error.message}`);
          }
        }
      };
      await Promise.all(Array.from({length: Math.min(2, cpus().length)}, work));
    }
  }
  return rows;
}

/** All sizes of a pattern that has several. */
function allSizes({file, name}) {
  const stem = /^(.*)-m\.json$/.exec(file)?.[1];
  if (stem === undefined) return [{file, name}];
  return ['xs', 's', 'm', 'l', 'xl'].map((size) => {
    const other = `${stem}-${size}.json`;
    return {file: other, name: basename(other, '.json')};
  });
}

const mean = ({mismatch, lengths}) =>
  mismatch.reduce((sum, d, k) => sum + d * lengths[k], 0) / lengths.reduce((a, b) => a + b, 0);

/** Adds the figures of one result to a row. */
function judge(result, mismatchOf, row) {
  const final = result.pieces.map((piece) => piece.alignment);
  const drafted = mismatchOf(result, 'rest', result.drafted);
  const placed = mismatchOf(result, 'rest', result.search);
  const aligned = mismatchOf(result, 'rest', final);
  const shaped = mismatchOf(result, 'shape', final);
  row.cases += 1;
  row.drafted += drafted.mean;
  row.placed += placed.mean;
  row.final += shaped.mean;
  if (shaped.mean > drafted.mean + limits.slip) row.whole += 1;
  const visibility = new Map(
    result.seamGroups.flatMap((group) => group.seams.map((k) => [k, group.visibility])),
  );
  shaped.seams.forEach((seam, k) => {
    if (!seam.counts) return;
    const [before, there, now] = [placed, aligned, shaped].map(({seams}) => mean(seams[k]));
    row.seams += 1;
    const least = Math.min(before, there);
    const met = visibility.get(k) < visible ? limits.seen : limits.met;
    if (least <= limits.lost && now > Math.max(met, least + limits.worse) + limits.slip)
      row.worse += 1;
    const share = now > limits.broken ? gained.broken : gained.met;
    const bend = bendOf(result, result.seams[k]);
    if (bend > limits.bent + limits.slip && now > share * there + limits.slip) row.vain += 1;
  });
}

/** Greatest distance of a seam's vertices, except its ends, from its line moved as a whole. [cm] */
function bendOf({pieces}, {a, b}) {
  const bends = [a, b].flatMap(({piece, vertices}) => {
    const [from, to] = ['rest', 'shape'].map((name) =>
      centred(vertices.map((v) => pieces[piece][name][v])),
    );
    const sum = (product) => from.reduce((all, point, k) => all + product(point, to[k]), 0);
    const turn = Math.atan2(
      sum(([x, y], [u, v]) => x * v - y * u),
      sum(([x, y], [u, v]) => x * u + y * v),
    );
    const [c, s] = [Math.cos(turn), Math.sin(turn)];
    return from
      .map(([x, y], k) => Math.hypot(c * x - s * y - to[k][0], s * x + c * y - to[k][1]))
      .slice(1, -1);
  });
  return Math.max(0, ...bends);
}

function centred(points) {
  const middle = [0, 1].map(
    (k) => points.reduce((sum, point) => sum + point[k], 0) / points.length,
  );
  return points.map(([x, y]) => [x - middle[0], y - middle[1]]);
}
