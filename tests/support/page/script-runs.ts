/**
 * Times for which scripts block a page, by Chromium's sampling profiler, so that other programs'
 * delays don't count.
 */
import type {Page} from 'playwright-core';

interface Profile {
  readonly nodes: readonly {id: number; callFrame: {functionName: string}; children?: number[]}[];
  readonly samples: readonly number[];
  /** [microseconds] */
  readonly timeDeltas: readonly number[];
}

/** Samples outside of scripts: the browser itself, which waits for the software renderer here. */
const others = new Set(['(program)', '(idle)', '(root)', '(garbage collector)']);

function runsOf({nodes, samples, timeDeltas}: Profile): readonly number[] {
  const names = new Map(nodes.map(({id, callFrame}) => [id, callFrame.functionName]));
  const runs: number[] = [];
  let run = 0;
  for (const [k, id] of samples.entries()) {
    if (!others.has(names.get(id) ?? '')) run += (timeDeltas[k] ?? 0) / 1000;
    else if (run > 0) {
      runs.push(run);
      run = 0;
    }
  }
  return runs.sort((a, b) => b - a);
}

/** Uninterrupted runs of the page's scripts during `act`, the longest first. [ms] */
export async function scriptRuns(
  page: Page,
  act: () => Promise<unknown>,
): Promise<readonly number[]> {
  const profiler = await page.context().newCDPSession(page);
  await profiler.send('Profiler.enable');
  await profiler.send('Profiler.setSamplingInterval', {interval: 1000});
  await profiler.send('Profiler.start');
  await act();
  const {profile} = await profiler.send('Profiler.stop');
  return runsOf(profile as Profile);
}
