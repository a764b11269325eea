import {expect, it} from 'vitest';

import {TaskQueue} from '@/solver/answers/answerer.js';

/** Tasks that the test ends; the record contains their starts. */
function worker(queue: TaskQueue) {
  const told: string[] = [];
  const ends = new Map<string, (failure?: Error) => void>();
  const begin = (name: string, signal?: AbortSignal) =>
    queue.take(() => {
      told.push(name);
      return new Promise<string>((resolve, reject) => {
        ends.set(name, (failure) => {
          if (failure) reject(failure);
          else resolve(name);
        });
      });
    }, signal);
  return {told, begin, end: (name: string, failure?: Error) => ends.get(name)?.(failure)};
}

it('lets as many work at once as it is told, the others in the order they came', async () => {
  const {told, begin, end} = worker(new TaskQueue(2));
  const all = ['a', 'b', 'c', 'd'].map((name) => begin(name));
  expect(told).toEqual(['a', 'b']);
  end('b');
  await all[1];
  await Promise.resolve();
  expect(told).toEqual(['a', 'b', 'c']);
  for (const name of ['a', 'c', 'd']) {
    end(name);
    await new Promise((resolve) => setTimeout(resolve));
  }
  expect(await Promise.all(all)).toEqual(['a', 'b', 'c', 'd']);
});

it('passes the turn on when work fails', async () => {
  const {told, begin, end} = worker(new TaskQueue(1));
  const [first, second] = [begin('a'), begin('b')];
  end('a', new Error('failed'));
  await expect(first).rejects.toThrow('failed');
  await new Promise((resolve) => setTimeout(resolve));
  expect(told).toEqual(['a', 'b']);
  end('b');
  await expect(second).resolves.toBe('b');
});

it('lets who waits leave at once, with the reason of the signal', async () => {
  const {told, begin, end} = worker(new TaskQueue(1));
  const controller = new AbortController();
  const first = begin('a');
  const second = begin('b', controller.signal);
  const third = begin('c');
  controller.abort('enough');
  await expect(second).rejects.toBe('enough');
  await expect(begin('d', AbortSignal.abort('too late'))).rejects.toBe('too late');
  end('a');
  await first;
  await new Promise((resolve) => setTimeout(resolve));
  end('c');
  await third;
  expect(told).toEqual(['a', 'c']);
});
