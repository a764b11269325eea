import {mkdirSync, readdirSync, readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';

import {clangTool} from './clang.mjs';
import {configure} from './cmake.mjs';
import {root, run, say} from './shell.mjs';

const folder = join(root, 'build/fuzz');
/** What runs find; beside the build, which is begun anew where it was moved. */
const found = join(root, 'build/fuzz-found');
/** Between the texts of an input, as in tests/fuzz/problem_fuzz.cpp. */
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

/** What there is to begin with: something small of every kind of file, and one of the samples. */
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

/** The names that files have, which chance alone would not find. */
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

/**
 * Reads and solves problems made by chance, going on from what earlier runs have found.
 * @param seconds for how long
 * @returns whether none of them was too much for the solver; one that was stays in build/fuzz-found
 */
export async function fuzz(seconds = 60) {
  const corpus = join(found, 'corpus');
  const compiler = [`-DCMAKE_CXX_COMPILER=${clangTool('clang++')}`];
  const build = ['--build', '--preset', 'fuzz', '--target', 'problem_fuzz', '--', '--quiet'];
  const built =
    (await configure('fuzz', compiler)) && (await run('cmake', build, {output: 'on failure'}));
  if (!built) return false;
  mkdirSync(corpus, {recursive: true});
  for (const [name, texts] of Object.entries(seeds())) {
    const input = texts.map((text) => JSON.stringify(text)).join(separator);
    writeFileSync(join(corpus, `seed-${name}`), input);
  }
  writeFileSync(join(folder, 'words.dict'), dictionary());
  const limits = [
    `-max_total_time=${seconds}`,
    '-max_len=20000',
    '-timeout=25',
    '-rss_limit_mb=2048',
  ];
  const words = [`-dict=${folder}/words.dict`, `-artifact_prefix=${found}/broken-`, corpus];
  const program = join(folder, 'tests/fuzz/problem_fuzz');
  say(`Solving problems made by chance for ${seconds} s ...`);
  return run(program, ['-print_final_stats=1', '-verbosity=0', ...limits, ...words]);
}
