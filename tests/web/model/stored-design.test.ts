import {readFileSync} from 'node:fs';

import * as fc from 'fast-check';
import {describe, expect, it} from 'vitest';

import {problemOfStored} from '@/model/documents/design-problem.js';
import type {Print} from '@/model/print/repeating-print.js';
import {repeatOf} from '@/model/print/repeat.js';
import {changesOf, printOfStored} from '@/model/documents/filed-design.js';
import {readStoredDesign, writeStoredDesign} from '@/model/documents/stored-design.js';
import {packageVersion} from '@/model/base/version.js';
import {FileError} from '@/model/base/versioned-file.js';
import {storedDesign} from '../../support/garments/designs.js';

type Json = Record<string, unknown>;

const written = (): Json => JSON.parse(writeStoredDesign(storedDesign)) as Json;

/** Every place in a document: the object or list that contains it, and its name there. */
function places(holder: unknown): [object, string][] {
  if (typeof holder !== 'object' || holder === null) return [];
  return Object.entries(holder).flatMap(([name, value]: [string, unknown]) => [
    [holder, name] as [object, string],
    ...places(value),
  ]);
}

/** The error of reading; undefined if there is none. */
function complaint(text: string): string | undefined {
  try {
    readStoredDesign(text, 'order.json');
    return undefined;
  } catch (error) {
    if (error instanceof FileError) return error.message;
    throw error;
  }
}

function changed(path: string, value: unknown): string {
  const file = written();
  const names = path.split('.');
  const last = names.pop() ?? '';
  const holder = names.reduce<unknown>((at, name) => Reflect.get(Object(at) as object, name), file);
  Reflect.set(Object(holder) as object, last, value);
  return JSON.stringify(file);
}

describe('a stored design', () => {
  it('is read as it was written', () => {
    expect(readStoredDesign(writeStoredDesign(storedDesign), 'x')).toEqual(storedDesign);
  });

  it.each(['auto', 'none'])('is read where its symmetries are %s', (symmetry) => {
    expect(readStoredDesign(changed('symmetry', symmetry), 'x').symmetry).toBe(symmetry);
  });

  it('asks for none where it lists none', () => {
    expect(readStoredDesign(changed('symmetry', []), 'x').symmetry).toBe('none');
  });

  it('may come with fields of the shop, which are left out', () => {
    expect(readStoredDesign(changed('customer', 17), 'x')).toEqual(storedDesign);
  });

  it('says so when a newer version stored it', () => {
    expect(complaint(changed('format', 'seamwise-design/2'))).toMatch(
      /^order\.json was stored by a newer Seamwise \(design format 2, this one reads 1\); update /,
    );
  });

  it('is refused with the name of the file when it is none', () => {
    expect(complaint('{')).toMatch(/^order\.json is not JSON; /);
    expect(complaint('null')).toMatch(/^order\.json is no design; /);
    expect(complaint(changed('format', 'seamwise-project/1'))).toMatch(/ is no design; /);
    expect(complaint(' '.repeat(300_000))).toMatch(/ is longer than /);
  });

  it.each([
    ['garment.sha256', 'A1'.repeat(32)],
    ['garment.size', 'x'.repeat(201)],
    ['print.colourway', ''],
    ['print.size.width', 0],
    ['print.turnDeg', 361],
    ['print.oneWay', 'yes'],
    ['print.group', 'p5'],
    ['symmetry', 'all'],
    ['symmetry', {}],
    ['symmetry.1.pieces', ['one']],
    ['method', 'worst'],
    ['options.maxChangeCm', -1],
    ['options.pins.front.angle', null],
    ['options.grain.default', 'off'],
    ['seed', 1.5],
    ['seed', 4294967296],
    ['fabric', 'wool'],
    ['alignments', []],
    ['alignments.front.translation', [1, 1e9]],
    ['result', ''],
    ['solver', '1.0.0; rm -rf'],
  ])('is refused when %s is %j', (path, value) => {
    const field = path.replace(/\.(\d)/, '[$1]');
    const message = complaint(changed(path, value));
    expect(message).toMatch(/^order\.json is damaged: '.* must be .*; correct it/);
    expect(message).toContain(`'${field}`);
  });

  it.each([
    'javascript:alert(1)',
    'data:application/json,{}',
    'blob:https://example.org/1',
    'ftp://example.org/p.json',
    'JavaScript:alert(1)',
    'java\nscript:alert(1)',
    ' javascript:alert(1)',
    '//example.org/p.json',
    '\\\\example.org\\p.json',
    'http:p.json',
    '',
    'x'.repeat(2001),
  ])('may not name a file by %j', (url) => {
    for (const path of ['garment.url', 'print.url']) {
      expect(complaint(changed(path, url))).toContain(
        `'${path}' must be an http:, https: or file:`,
      );
    }
  });

  it('may name files near and far', () => {
    for (const url of ['p.json', './a:b.json', '/p.json', 'file:///p.json', 'HTTPS://a.b/p?q#r']) {
      expect(complaint(changed('print.url', url))).toBeUndefined();
    }
  });

  it('is read or refused with one sentence, whatever is in its fields', () => {
    const spots = places(written()).length;
    fc.assert(
      fc.property(
        fc.nat(spots - 1),
        fc.oneof(fc.jsonValue(), fc.constant(undefined), fc.constantFrom(1e308, -0, '__proto__')),
        (spot, value) => {
          const file = written();
          const [holder, name] = places(file)[spot] ?? [file, 'format'];
          Reflect.set(holder, name, value);
          const message = complaint(JSON.stringify(file));
          if (message !== undefined) expect(message).toMatch(/^order\.json (is|was) [^\n]*; .*\.$/);
        },
      ),
      {seed: 1, numRuns: 2000},
    );
  });

  it('is read or refused with one sentence, whatever becomes of its text', () => {
    const text = writeStoredDesign(storedDesign);
    fc.assert(
      fc.property(fc.nat(text.length), fc.nat(40), fc.string({maxLength: 20}), (at, cut, put) => {
        const message = complaint(text.slice(0, at) + put + text.slice(at + cut));
        if (message !== undefined) expect(message).toMatch(/^order\.json (is|was) /);
      }),
      {seed: 1, numRuns: 2000},
    );
  });
});

describe('the print of a stored design', () => {
  const file: Print = {
    group: 'p6m',
    w1: [8, 0],
    w2: [4, 6.928203230275509],
    image: 'day.svg',
    colourways: [
      {name: 'Day', image: 'day.svg'},
      {name: 'Night', image: 'night.svg'},
    ],
  };
  const text = JSON.stringify(file);
  const {garment, print, ...rest} = storedDesign;
  const plain = {garment, ...rest, print: {url: print.url, sha256: print.sha256}};
  const shown = {group: file.group, ...repeatOf(file), oneWay: false, cell: 'primitive'} as const;

  it('is that of its file, to the letter, when nothing was changed', () => {
    expect(changesOf(shown, file)).toEqual({});
    expect(problemOfStored(plain, {garment: '{}', print: text}).print).toBe(text);
  });

  it('has the changes, and nothing but the changes', () => {
    const changes = changesOf({...shown, turnDeg: 90, oneWay: true}, file);
    expect(changes).toEqual({turnDeg: 90, oneWay: true});
    const turned = printOfStored({print: {...plain.print, ...changes, colourway: 'night'}}, text);
    expect(turned).toEqual({
      ...file,
      w1: [0, 8],
      w2: [-6.92820323, 4],
      turnDeg: 90,
      oneWay: true,
      image: 'night.svg',
    });
  });

  it('has the size that was asked for', () => {
    const size = {width: 10, height: 10, angleDeg: 90};
    const resized = changesOf({...shown, group: 'p2', size}, file);
    expect(resized).toEqual({group: 'p2', size});
    const {group, w1, w2} = printOfStored({print: {...plain.print, ...resized}}, text);
    expect({group, w1, w2}).toEqual({group: 'p2', w1: [10, 0], w2: [0, 10]});
  });

  it.each([
    ['a colourway that it has not', {colourway: 'Noon'}, text, "has no colourway 'Noon'"],
    ['a file that is no print', {}, '{"group": "p6m"}', "is no print file: 'w1' must be"],
    ['a file that is no JSON', {}, '<html>', 'is no print file: it is not JSON'],
    ['colourways that are none', {}, text.replace('"Day"', '1'), "'colourways[0].name'"],
  ])('is refused for %s', (_, changes, content, words) => {
    const read = () => printOfStored({print: {...plain.print, ...changes}}, content);
    expect(read).toThrow(FileError);
    expect(read).toThrow(words);
  });
});

it('is stored with the version of the package', () => {
  const file = new URL('../../../package.json', import.meta.url);
  expect(packageVersion).toBe(
    (JSON.parse(readFileSync(file, 'utf8')) as {version: string}).version,
  );
});
