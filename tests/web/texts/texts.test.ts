import {readFileSync} from 'node:fs';

import {describe, expect, it} from 'vitest';

import {en} from '@/texts/en.js';
import {loadTexts, textsOf} from '@/texts/texts.js';
import {languages, preferencesFor} from '@/texts/preferences.js';
import type {Samples} from '@/workbench/samples.js';

const samples = JSON.parse(readFileSync('public/samples.json', 'utf8')) as Samples;

type Word = string | ((...given: readonly unknown[]) => string);

/** All texts below a name, by their paths. */
function wordsOf(texts: unknown, path = ''): [path: string, word: Word][] {
  if (typeof texts === 'string' || typeof texts === 'function') return [[path, texts as Word]];
  return Object.entries(texts as object).flatMap(([name, one]) =>
    wordsOf(one, path ? `${path}.${name}` : name),
  );
}

/** Texts that are the same in all languages, or by chance in related ones. */
const alike = new RegExp(
  `^(?:${[
    'app.name|controls.methods.paper|legend.asPaper|legend.none|pattern.zoom|remedies.effect|lists.weight',
    'print.dpi|print.measure.points.1|grain.other',
    'lists.size|lists.numbered|lists.of|pattern.piece|lists.matches.double|keys\\..*|keyNames\\..*',
  ].join('|')})$`,
);

const counted = new Set([
  ...['pattern.seams', 'symmetry.foundCount', 'remedies.title', 'remedies.more'],
]);

/** Sample arguments of a text, as figures or as names. */
const argumentsOf = (path: string, word: Word): readonly unknown[] =>
  Array.from({length: word.length}, (_, k) => (counted.has(path) ? 7003 + k : `<${k}>`));

describe.each(languages.filter((language) => language !== 'en'))('the texts in %s', (language) => {
  it('are English until they are loaded, and then their own', async () => {
    expect(textsOf(language)).toBe(en);
    expect(await loadTexts(language)).toBe(true);
    expect(await loadTexts(language)).toBe(false);
    expect(textsOf(language)).not.toBe(en);
    expect(textsOf(language, {app: {undo: 'Oops'}}).app).toEqual({
      ...textsOf(language).app,
      undo: 'Oops',
    });
  });

  it('say all that they are told', async () => {
    await loadTexts(language);
    const own = new Map(wordsOf(textsOf(language)));
    const silent = wordsOf(en).flatMap(([path, english]) => {
      const word = own.get(path);
      if (typeof english !== 'function' || typeof word !== 'function') return [];
      const given = argumentsOf(path, english);
      const said = word(...given);
      return given.every((one) => said.includes(String(one))) ? [] : [`${path}: ${said}`];
    });
    expect(silent).toEqual([]);
    expect([...own.values()].filter((word) => word === '')).toEqual([]);
  });

  it('are not left in English', async () => {
    await loadTexts(language);
    const own = new Map(wordsOf(textsOf(language)));
    const english = wordsOf(en).flatMap(([path, word]) => {
      const given = argumentsOf(path, word);
      const say = (one: Word | undefined): string | undefined =>
        typeof one === 'function' ? one(...given) : one;
      return say(word) === say(own.get(path)) && !alike.test(path) ? [`${path}: ${say(word)}`] : [];
    });
    expect(english).toEqual([]);
  });

  it('name every garment, print and colour that comes with the page', async () => {
    await loadTexts(language);
    const named = textsOf(language).samples;
    expect(Object.keys(named.garments)).toEqual(samples.garments.map(({style}) => style));
    expect(Object.keys(named.prints)).toEqual(samples.prints.map(({name}) => name));
    const colours = samples.prints.flatMap(({colourways}) => colourways.map(({name}) => name));
    expect(Object.keys(named.colourways).sort()).toEqual([...new Set(colours)].sort());
  });

  it('are those of whoever reads that language, in any country', () => {
    expect(preferencesFor(language).language).toBe(language);
    expect(preferencesFor(`${language}-CH`).language).toBe(language);
  });
});

it('speaks English to everybody else', () => {
  expect(preferencesFor('pt-BR').language).toBe('en');
});
