import {expect, it} from 'vitest';

import {choice, parseArguments, wholeNumber} from '@/cli/base/arguments.js';

const grammar = {files: ['the file'], valued: ['--seed', '--mode'], switches: ['--json']};
const parse = (...words: string[]) => parseArguments(words, grammar);

it('reads files, values and switches in any order', () => {
  const args = parse('--json', '--seed', '3', 'a.json');
  expect(args.files).toEqual(['a.json']);
  expect(args.value('--seed')).toBe('3');
  expect(args.has('--json')).toBe(true);
  expect(args.value('--mode')).toBeUndefined();
});

it('reads a value after an equals sign', () => {
  expect(parse('--seed=3', 'a.json').value('--seed')).toBe('3');
});

it('takes everything after -- for files', () => {
  expect(parse('--', '--json').files).toEqual(['--json']);
});

it.each([
  [['--sead', '3', 'a.json'], "unknown flag '--sead'"],
  [['-x', 'a.json'], "unknown flag '-x'"],
  [['a.json', '--seed'], '--seed needs a value'],
  [['a.json', '--seed', '--json'], '--seed needs a value'],
  [['a.json', '--seed='], '--seed needs a value'],
  [['a.json', '--json=1'], '--json takes no value'],
  [['a.json', '--seed', '1', '--seed', '1'], '--seed is given twice'],
  [['a.json', 'b.json'], "'b.json' is one argument too many"],
  [['--seed', '1'], 'the file is missing'],
])('refuses %j', (words, sentence) => {
  expect(() => parse(...words)).toThrow(sentence);
});

it.each(['0', '1', '4294967295'])('takes %s for a seed', (seed) => {
  expect(wholeNumber(parse('a', '--seed', seed), '--seed')).toBe(Number(seed));
});

it.each(['-1', '1.5', 'one', '4294967296', '0x10', '1e3', ' 1'])('refuses %j as a seed', (seed) => {
  expect(() => wholeNumber(parse('a', '--seed', seed), '--seed')).toThrow(/--seed is '.*', but/);
});

it('offers the choices when a value is none of them', () => {
  const args = parse('a', '--mode', 'fast');
  expect(() => choice(args, '--mode', ['best', 'paper'])).toThrow('must be one of best, paper');
});
