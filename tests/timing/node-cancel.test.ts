/**
 * The time from a cancel to its effect in Node, as a quotient by the time of the cancelled work.
 */
import {solve} from 'seamwise/node';
import {expect, it} from 'vitest';

import {checks, sample} from '../support/garments/samples.js';

it('of a solve: a slice of it', async () => {
  const garment = sample('patchwork-jacket');
  const whole = {start: performance.now(), end: NaN};
  await solve({garment, print: checks});
  whole.end = performance.now();
  const latencies: number[] = [];
  for (let seed = 2; seed < 7; seed++) {
    const controller = new AbortController();
    let aborted = NaN;
    const onProgress = ({fraction}: {fraction: number}) => {
      if (fraction === 0 || controller.signal.aborted) return;
      aborted = performance.now();
      controller.abort();
    };
    const solving = solve({garment, print: checks, seed}, {signal: controller.signal, onProgress});
    await expect(solving).rejects.toMatchObject({name: 'AbortError'});
    latencies.push(performance.now() - aborted);
  }
  expect(Math.min(...latencies) / (whole.end - whole.start)).toBeLessThan(1 / 20);
});
