import {expect, it} from 'vitest';

import {amended, begun, redone, stepped, undone, type History} from '@/model/design/history.js';

const after = (...states: readonly string[]): History<string> =>
  states.reduce((history, state) => stepped(history, state), begun('start'));

it('takes steps back to where it began, and no further', () => {
  const once = undone(after('a', 'b'));
  expect(once?.present).toBe('a');
  const twice = once && undone(once);
  expect(twice?.present).toBe('start');
  expect(twice && undone(twice)).toBeUndefined();
});

it('takes steps again in the order in which they were taken', () => {
  const start = [1, 2, 3].reduce<History<string>>(
    (history) => undone(history) ?? history,
    after('a', 'b', 'c'),
  );
  const once = redone(start);
  const twice = once && redone(once);
  expect([start.present, once?.present, twice?.present]).toEqual(['start', 'a', 'b']);
  expect(redone(after('a'))).toBeUndefined();
});

it('forgets what was taken back when another step is taken', () => {
  const back = undone(after('a', 'b')) ?? begun('none');
  const other = stepped(back, 'c');
  expect(other).toEqual({past: ['start', 'a'], present: 'c', future: []});
});

it('amends the present without a step', () => {
  const back = undone(after('a', 'b')) ?? begun('none');
  expect(amended(back, 'A')).toEqual({past: ['start'], present: 'A', future: ['b']});
});

it('forgets the oldest of very many steps', () => {
  const long = after(...Array.from({length: 310}, (_, k) => String(k)));
  expect(long.past).toHaveLength(300);
  expect(long.past[0]).toBe('9');
  expect(long.present).toBe('309');
});

it('leaves the history that it was given as it was', () => {
  const history = after('a');
  undone(history);
  stepped(history, 'b');
  expect(history).toEqual({past: ['start'], present: 'a', future: []});
});
