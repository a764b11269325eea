// Rules that every result keeps, measured over many results from their geometry alone.
import {readdirSync, readFileSync} from 'node:fs';
import {cpus} from 'node:os';
import {basename, join} from 'node:path';

import {root} from '../../web/setup/shell.mjs';

/** Limits for seams in cm and shares, from docs/life-of-a-print.md. */
const limits = {worse: 0.03, met: 0.1, gained: 0.75, moved: 0.1, slip: 1e-6};
const grains = ['on', 'free'];

/**
 * Measures every sample garment, or those of `--garments`, in every sample print, on grain and at
 * any angle.
 * @returns a row for each garment and grain: cases, seams, and the number that breaks each rule
 */
export async function measureRules({garments, thorough, say, fail}) {
  const {solve} = await import('../../dist/node/index.js');
  const {fitOf} = await import('../../dist/picture/fit.js');
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
            judge(await solve(problem), fitOf, into);
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
function judge(result, fitOf, row) {
  const final = result.pieces.map((piece) => piece.alignment);
  const drafted = fitOf(result, 'rest', result.drafted);
  const placed = fitOf(result, 'rest', result.search);
  const aligned = fitOf(result, 'rest', final);
  const shaped = fitOf(result, 'shape', final);
  row.cases += 1;
  row.drafted += drafted.mean;
  row.placed += placed.mean;
  row.final += shaped.mean;
  if (shaped.mean > drafted.mean + limits.slip) row.whole += 1;
  shaped.seams.forEach((seam, k) => {
    if (!seam.counts) return;
    const [before, there, now] = [placed, aligned, shaped].map(({seams}) => mean(seams[k]));
    row.seams += 1;
    const isMet = now < limits.met;
    if (!isMet && now > Math.min(before, there) + limits.worse + limits.slip) row.worse += 1;
    const moved = movedOf(result, result.seams[k]);
    if (moved > limits.moved + limits.slip && now > limits.gained * there + limits.slip)
      row.vain += 1;
  });
}

/** Greatest movement of a seam's vertices, except at its ends. [cm] */
function movedOf({pieces}, {a, b}) {
  const moves = [a, b].flatMap(({piece, vertices}) =>
    vertices.slice(1, -1).map((v) => {
      const {rest, shape} = pieces[piece];
      return Math.hypot(shape[v][0] - rest[v][0], shape[v][1] - rest[v][1]);
    }),
  );
  return Math.max(0, ...moves);
}
