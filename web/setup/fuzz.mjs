import {mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';

import {root, run} from './shell.mjs';

const folder = join(root, 'build/sanitize');
/** Findings of all runs; outside of the build's folder, which is removed after a move. */
const found = join(root, 'build/fuzz-found');
/** Separator of the texts in an input, as in tests/fuzz/problem_fuzz.cpp. */
const separator = '\x1e';

const square = [
  [0, 0],
  [10, 0],
  [10, 10],
  [0, 10],
];
const panel = {vertices: square, edges: square.map((_, k) => ({endpoints: [k, (k + 1) % 4]}))};
const curved = {...panel, edges: panel.edges.with(0, {endpoints: [0, 1], curvature: [0.5, 0.1]})};
const stitches = [
  [
    {panel: 'a', edge: 1},
    {panel: 'b', edge: 3},
  ],
];
const two = {pattern: {panels: {a: panel, b: curved}, stitches}};
const print = {group: 'pmm', w1: [5, 0], w2: [0, 7]};

/** Initial inputs: a small example of every kind of file, and one of the samples. */
function seeds() {
  const sample = (path) => JSON.parse(readFileSync(join(root, 'public', path), 'utf8'));
  const axis = {
    kind: 'piece',
    piece: 'a',
    axis: [
      [5, 0],
      [5, 10],
    ],
  };
  const options = {grain: {default: 'on'}, maxChangeCm: 0.5, pins: {a: {x: 1, y: 2, angle: 0}}};
  return {
    two: [two, print],
    options: [two, print, options],
    pair: [two, print, {}, {symmetries: [{kind: 'pair', pieces: ['a', 'b']}]}],
    axis: [two, {...print, group: 'p4m', w2: [0, 5]}, {maxChangeCm: 0}, {symmetries: [axis]}],
    tee: [sample('garments/tee-s.json'), sample('prints/p3.json')],
  };
}

/** The field names of files, which chance alone would not find. */
function dictionary() {
  const words = new Set();
  const visit = (schema) => {
    if (typeof schema !== 'object' || schema === null) return;
    Object.keys(schema.properties ?? {}).forEach((name) => words.add(name));
    for (const word of schema.enum ?? []) if (typeof word === 'string') words.add(word);
    Object.values(schema).forEach(visit);
  };
  const schemas = join(root, 'public/schema');
  for (const file of readdirSync(schemas))
    visit(JSON.parse(readFileSync(join(schemas, file), 'utf8')));
  return [...words].map((word) => `"\\"${word.replaceAll(/["\\]/g, '\\$&')}\\""`).join('\n');
}

/** Ends a run after a time; it continues from the findings of earlier runs. */
export const forSeconds = (seconds) => ({
  corpus: join(found, 'corpus'),
  limit: `-max_total_time=${seconds}`,
});

/** Ends a run after a number of problems, always the same ones. */
export const forProblems = (count) => {
  const corpus = join(folder, 'corpus');
  rmSync(corpus, {recursive: true, force: true});
  return {corpus, limit: `-runs=${count}`};
};

/**
 * Reads and solves random problems in the build with sanitizers.
 * @returns whether the solver survived all of them; a problem that broke it stays in
 * build/fuzz-found
 */
export async function fuzz({corpus, limit}) {
  const build = ['--build', '--preset', 'sanitize', '--target', 'problem_fuzz', '--', '--quiet'];
  if (!(await run('cmake', build, {output: 'on failure'}))) return false;
  mkdirSync(corpus, {recursive: true});
  mkdirSync(found, {recursive: true});
  for (const [name, texts] of Object.entries(seeds())) {
    const input = texts.map((text) => JSON.stringify(text)).join(separator);
    writeFileSync(join(corpus, `seed-${name}`), input);
  }
  writeFileSync(join(folder, 'words.dict'), dictionary());
  const limits = [limit, '-seed=1', '-max_len=20000', '-timeout=25', '-rss_limit_mb=2048'];
  const words = [`-dict=${folder}/words.dict`, `-artifact_prefix=${found}/broken-`, corpus];
  const program = join(folder, 'tests/fuzz/problem_fuzz');
  return run(program, ['-print_final_stats=1', '-verbosity=0', ...limits, ...words]);
}
