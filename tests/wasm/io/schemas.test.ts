import {readdirSync, readFileSync} from 'node:fs';

import {Ajv2020} from 'ajv/dist/2020.js';
import * as fc from 'fast-check';
import {
  convert,
  designOf,
  marker,
  mirror,
  order,
  orderRecord,
  readStoredDesign,
  sha256Of,
  solve,
  symmetries,
  writeStoredDesign,
} from 'seamwise/node';
import {describe, expect, it} from 'vitest';

import {storedDesign} from '../../support/garments/designs.js';
import {problem} from '../../support/garments/random-problems.js';
import {checks, sample, twoStrips} from '../../support/garments/samples.js';

const publicFolder = new URL('../../../public/', import.meta.url);

const kinds = ['design', 'garment', 'layplan', 'options', 'order', 'print', 'symmetries'] as const;

/** Validator by the schema of one kind of file. */
function schema(kind: (typeof kinds)[number]) {
  const ajv = new Ajv2020({strict: true, strictTypes: false, strictTuples: false});
  for (const name of kinds) {
    const file = new URL(`schema/seamwise-${name}-1.schema.json`, publicFolder);
    ajv.addSchema(JSON.parse(readFileSync(file, 'utf8')) as object, name);
  }
  const validate = ajv.getSchema(kind);
  if (!validate) throw new Error(`there is no schema of a ${kind}`);
  return (document: unknown) => (validate(document) ? [] : validate.errors);
}

describe('the schemas accept', () => {
  it.each(['tee', 'gathered-skirt', 'princess-dress'] as const)(
    'the %s in the own format',
    async (name) => {
      expect(schema('garment')(JSON.parse(await convert(sample(name))))).toEqual([]);
    },
  );

  it('every sample print', () => {
    const folder = new URL('prints/', publicFolder);
    const files = readdirSync(folder).filter((name) => name.endsWith('.json'));
    expect(files.length).toBeGreaterThanOrEqual(17);
    for (const name of files) {
      const print: unknown = JSON.parse(readFileSync(new URL(name, folder), 'utf8'));
      expect(schema('print')(print)).toEqual([]);
    }
  });

  it('symmetries as they are found', async () => {
    expect(schema('symmetries')(await symmetries(sample('princess-dress')))).toEqual([]);
  });

  it('a symmetry as it was measured', async () => {
    const measured = await mirror(twoStrips(), {kind: 'pair', pieces: ['left', 'right']});
    expect(schema('symmetries')({symmetries: [measured]})).toEqual([]);
  });

  it('designs as they are written', async () => {
    const written = writeStoredDesign(storedDesign);
    expect(schema('design')(JSON.parse(written))).toEqual([]);
    const solved = await solve({garment: twoStrips(), print: checks});
    const again = writeStoredDesign(designOf(storedDesign, solved));
    expect(schema('design')(JSON.parse(again))).toEqual([]);
  });

  it('the record of an order', async () => {
    const files = [twoStrips(), checks].map((file) => JSON.stringify(file));
    const [garment = '', print = ''] = files;
    const [garmentFile, printFile] = files.map((text, k) => ({
      url: `${k}.json`,
      sha256: sha256Of(text),
    }));
    const solved = await solve({garment, print});
    if (!garmentFile || !printFile) throw new Error('A file is missing.');
    const choice = {symmetry: 'auto', method: 'best', options: {}, seed: 1} as const;
    const sold = designOf({...choice, garment: garmentFile, print: printFile}, solved);
    const read = (url: string) =>
      Promise.resolve(new TextEncoder().encode(files[Number.parseInt(url)]));
    for (const cloth of [undefined, {widthCm: 140}]) {
      const record = await orderRecord(await order(sold, {read, ...(cloth && {cloth})}));
      expect(schema('order')(JSON.parse(JSON.stringify(record)))).toEqual([]);
    }
  });

  it('plans of pieces on cloth', async () => {
    const solved = await solve({garment: twoStrips(), print: checks});
    const settings = {widthCm: 60, effort: 0, copies: 2};
    for (const ignoresPrint of [false, true]) {
      const plan = await marker([solved], {...settings, ignoresPrint});
      expect(schema('layplan')(plan)).toEqual([]);
      const [first] = plan.placements;
      const half = {...plan, placements: [{...first, cut: [[0, 0]]}]};
      expect(schema('layplan')(half)).not.toEqual([]);
    }
  });

  it('whatever the solver is tried with', () => {
    const [print, options] = [schema('print'), schema('options')];
    fc.assert(
      fc.property(problem, (one) => {
        expect(print(JSON.parse(one.print))).toEqual([]);
        expect(options(JSON.parse(one.options))).toEqual([]);
      }),
      {seed: 1, numRuns: 200},
    );
  });
});

describe('schema and reader both refuse', () => {
  it.each([
    ['no hash of the garment', 'garment', {url: 'tee.json'}],
    ['a script for a URL', 'print', {...storedDesign.print, url: 'javascript:alert(1)'}],
    ['another host behind a path', 'print', {...storedDesign.print, url: '//example.org/p.json'}],
    ['an unknown symmetry', 'symmetry', 'all'],
    ['an unknown method', 'method', 'worst'],
    ['a negative seed', 'seed', -1],
    ['a piece without a place', 'alignments', {front: {angle: 0}}],
    ['half a hash', 'result', 'abc'],
    ['no version', 'solver', 'newest'],
    ['a piece without a name', 'names', {front: ''}],
    ['another format', 'format', 'seamwise-design/2'],
  ])('a design with %s', (_, field, value) => {
    const written = JSON.parse(writeStoredDesign(storedDesign)) as object;
    const document = {...written, [field]: value};
    expect(schema('design')(document)).not.toEqual([]);
    expect(() => readStoredDesign(JSON.stringify(document), 'x')).toThrow();
  });
});

describe('schema and solver both refuse', () => {
  const strips = {garment: twoStrips(), print: checks};
  const garment = (pattern: object) => ({format: 'seamwise-garment/1', pattern});

  it.each([
    ['a garment without panels', garment({panels: {}})],
    ['a panel without edges', garment({panels: {front: {vertices: [[0, 0]]}}})],
    ['a garment of an unknown version', {...twoStrips(), format: 'seamwise-garment/9'}],
  ])('%s', async (_, document) => {
    expect(schema('garment')(document)).not.toEqual([]);
    await expect(solve({...strips, garment: JSON.stringify(document)})).rejects.toThrow();
  });

  it.each([
    ['an unknown group', {...checks, group: 'p9'}],
    ['a lattice of one vector', {group: 'p1', w1: [1, 0]}],
    ['a text for a length', {...checks, w1: ['4', 0]}],
  ])('a print with %s', async (_, document) => {
    expect(schema('print')(document)).not.toEqual([]);
    await expect(solve({...strips, print: JSON.stringify(document)})).rejects.toThrow();
  });

  it.each([
    ['an unknown field', {speed: 3}],
    ['a negative greatest change', {maxChangeCm: -1}],
    ['edges that are too long', {edgeLengthCm: 2}],
    ['an unknown grain lock', {grain: {default: 'sideways'}}],
    ['a grain rule that says nothing', {grain: {pieces: {left: {}}}}],
    ['a grain line in words', {grain: {pieces: {left: {angleDeg: 'up'}}}}],
    ['a pin without a place', {pins: {left: {angle: 0}}}],
  ])('options with %s', async (_, document) => {
    expect(schema('options')(document)).not.toEqual([]);
    await expect(solve({...strips, options: JSON.stringify(document)})).rejects.toThrow();
  });

  it.each([
    ['an unknown kind', {kind: 'triple', pieces: ['left', 'right']}],
    [
      'both axis and seams',
      {
        kind: 'piece',
        piece: 'left',
        axis: [
          [2, 0],
          [2, 9],
        ],
        seams: [1, 3],
      },
    ],
    ['one piece for a pair', {kind: 'pair', pieces: ['left']}],
  ])('a symmetry with %s', async (_, entry) => {
    const document = {symmetries: [entry]};
    expect(schema('symmetries')(document)).not.toEqual([]);
    await expect(solve({...strips, symmetry: JSON.stringify(document)})).rejects.toThrow();
  });
});
