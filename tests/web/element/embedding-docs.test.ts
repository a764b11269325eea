/** docs/embedding.md lists the complete API and nothing else, and its programs run. */
import {execFile} from 'node:child_process';
import {readdirSync, readFileSync} from 'node:fs';
import {join} from 'node:path';
import {fileURLToPath} from 'node:url';
import {promisify} from 'node:util';

import {expect, it} from 'vitest';

import {spellings} from '@/element/garment/attributes.js';
import {bubbling} from '@/element/garment/events.js';
import {SeamwiseGarment} from '@/element/seamwise-garment.js';
import {tokens} from '@/editor/style/tokens.js';
import {failureCodes, pageFailureCodes} from '@/model/base/failure.js';
import {rowsOf, snippetWith} from '../../support/package/embedding.js';

const project = fileURLToPath(new URL('../../..', import.meta.url));
const source = (path: string): string => readFileSync(`${project}/${path}`, 'utf8');
const elementFiles = [
  'web/src/element/seamwise-garment.ts',
  'web/src/element/garment/attribute-element.ts',
  'web/src/element/garment/form-element.ts',
];

const all = (text: string, pattern: RegExp): string[] =>
  [...new Set([...text.matchAll(pattern)].map(([, name = '']) => name))].sort();

/** The names in the first column of a table, several in one cell. */
const named = (column: string): string[] =>
  rowsOf(column)
    .flatMap(([names = '']) => names.replaceAll(/\([^)]*\)/g, '').split(', '))
    .sort();

/** The body of a declaration after its head. */
const bodyOf = (text: string, head: string): string =>
  text.slice(text.indexOf(head)).split(/\n}|;\n\n/)[0] ?? '';

it('lists the attributes, each with its property', () => {
  const observed = SeamwiseGarment.observedAttributes.filter((name) => !spellings.has(name));
  expect(named('attribute')).toEqual(observed.sort());
  for (const [attribute = '', property = ''] of rowsOf('attribute')) {
    expect(property).toBe(attribute.replace(/-(.)/g, (_, letter: string) => letter.toUpperCase()));
  }
});

it('lists the other properties, and the methods', () => {
  const members = elementFiles
    .flatMap((file) => all(source(file), /^ {2}(?:readonly |get |set |async )?(\w+)(?:\(| = )/gm))
    .filter((name) => name !== 'constructor' && !name.endsWith('Callback'));
  const mirrored = rowsOf('attribute').map(([, property]) => property);
  const documented = [...named('property'), ...named('method')];
  expect(documented.sort()).toEqual(
    [...new Set(members)].filter((name) => !mirrored.includes(name)).sort(),
  );
});

it('lists the events, and says which of them bubble', () => {
  const events = bodyOf(source('web/src/element/garment/events.ts'), 'interface GarmentEvents');
  expect(named('event')).toEqual(all(events, /^ {2}readonly (\w+):/gm));
  const heard = rowsOf('event').filter(([, bubbles]) => bubbles === 'yes');
  expect(heard.map(([name]) => name).sort()).toEqual([...bubbling].sort());
});

it('lists the states', () => {
  const states = bodyOf(source('web/src/element/garment/events.ts'), 'type GarmentState');
  expect(named('state')).toEqual(all(states, /'(\w+)'/g));
});

it('lists slots, parts and variables', () => {
  const folder = 'web/src/element/garment';
  const files = [
    ...elementFiles,
    ...readdirSync(join(project, folder)).map((file) => `${folder}/${file}`),
  ];
  const templates = files.map(source).join('\n');
  expect(named('slot')).toEqual(all(templates, /<slot name="(\w+)"/g));
  expect(named('part')).toEqual(all(templates, /\bpart="(\w+)"/g));
  const [usual = '', ...elsewhere] = tokens.cssText.split('@media');
  const variablesIn = (css: string): string[][] =>
    [...css.matchAll(/(--[\w-]+): (.+);/g)].map(([, name = '', value = '']) => [name, value]);
  const rows = rowsOf('variable');
  expect(rows.map((row) => row.slice(0, 2))).toEqual(variablesIn(usual));
  for (const [name, value] of elsewhere.flatMap(variablesIn)) {
    expect(rows.find(([listed]) => listed === name)?.[2]).toContain(value);
  }
});

it('lists every code of a failure', () => {
  expect(named('code')).toEqual([...Object.keys(failureCodes), ...pageFailureCodes].sort());
});

it('lists the entries of the package', () => {
  const {exports} = JSON.parse(source('package.json')) as {exports: object};
  const entries = Object.keys(exports).filter((entry) => entry !== './package.json');
  expect(named('entry')).toEqual(entries.map((entry) => `seamwise${entry.slice(1)}`).sort());
});

/** Output of a module run in the project, where the package can import itself by its name. */
async function printed(program: string): Promise<string> {
  const args = ['--input-type=module', '--eval', program];
  return (await promisify(execFile)(process.execPath, args, {cwd: project})).stdout;
}

it('has a first program for Node that runs', async () => {
  expect(await printed(snippetWith('js', 'console.log(metrics'))).toMatch(/^\d+\.\d\n$/);
});

it('has a workshop that cuts what a page has sold', async () => {
  const sold = `
    import {designOf, problemOfStored, sha256Of, solve} from 'seamwise/node';
    const [garment, print] = await Promise.all([...shelf.values()].map((path) => readFile(path)));
    const [garmentUrl, printUrl] = shelf.keys();
    const stored = {
      garment: {url: garmentUrl, sha256: sha256Of(garment)},
      print: {url: printUrl, sha256: sha256Of(print)},
      ...{symmetry: 'auto', method: 'best', options: {}, seed: 1},
    };
    const problem = problemOfStored(stored, {garment: String(garment), print: String(print)});
    const design = designOf(stored, await solve(problem));
    const {reproduced, differenceCm} = await cut(design);
    const foreign = {...design, print: {...design.print, url: '/etc/passwd'}};
    const refusal = await cut(foreign).catch(({message}) => message);
    console.log(JSON.stringify([reproduced, differenceCm, refusal]));
  `;
  expect(JSON.parse(await printed(snippetWith('js', 'order(design') + sold))).toEqual([
    true,
    expect.closeTo(0),
    '/etc/passwd is none of ours.',
  ]);
});
