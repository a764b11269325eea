/** `npm run dev`: reactions to changes, and the end of all its processes. */
import {spawn} from 'node:child_process';
import {once} from 'node:events';
import {createServer, type AddressInfo} from 'node:net';
import {fileURLToPath} from 'node:url';

import {afterEach, beforeEach, describe, expect, it, vi} from 'vitest';

import {again} from '../../../web/setup/again.mjs';

const unexpected = (error: unknown): void => {
  throw error;
};

describe('builds', () => {
  const after = (milliseconds: number) => vi.advanceTimersByTimeAsync(milliseconds);

  beforeEach(() => {
    vi.useFakeTimers();
  });
  afterEach(() => {
    vi.useRealTimers();
  });

  it('once for changes that come together', async () => {
    const build = vi.fn();
    const changed = again(build, unexpected, 20);
    changed();
    await after(5);
    changed();
    changed();
    await after(100);
    expect(build).toHaveBeenCalledTimes(1);
  });

  it('once more for changes that come while it builds', async () => {
    let [builds, atOnce, most] = [0, 0, 0];
    const build = async (): Promise<void> => {
      builds++;
      most = Math.max(most, ++atOnce);
      await new Promise((resolve) => setTimeout(resolve, 100));
      atOnce--;
    };
    const changed = again(build, unexpected, 0);
    changed();
    await after(20);
    changed();
    await after(20);
    changed();
    await after(300);
    expect({builds, most}).toEqual({builds: 2, most: 1});
  });

  it('at the next change after a failure, which it reports', async () => {
    let builds = 0;
    const said: unknown[] = [];
    const build = (): void => {
      if (++builds === 1) throw new Error('a semicolon is missing');
    };
    const changed = again(build, (error) => said.push(error), 0);
    changed();
    await after(50);
    changed();
    await after(50);
    expect({builds, said}).toEqual({builds: 2, said: [new Error('a semicolon is missing')]});
  });
});

async function freePort(): Promise<number> {
  const server = createServer().listen(0);
  await once(server, 'listening');
  const {port} = server.address() as AddressInfo;
  server.close();
  return port;
}

it('serves the page from its sources, and ends with all that it has begun', async () => {
  const port = await freePort();
  const script = fileURLToPath(new URL('../../../web/setup/dev.mjs', import.meta.url));
  const child = spawn(process.execPath, [script], {
    env: {...process.env, PORT: String(port)},
    stdio: ['ignore', 'ignore', 'pipe'],
  });
  let said = '';
  const closed = once(child.stderr, 'close'); // the last process has ended
  await new Promise<void>((resolve) => {
    child.stderr.on('data', (chunk: Buffer) => {
      said += chunk.toString();
      if (said.includes('watch mode')) resolve(); // both are running by then
    });
    child.stderr.on('close', resolve);
  });
  expect(said).toContain(`http://localhost:${port}`);
  const page = await fetch(`http://localhost:${port}/src/app/main.ts`);
  expect(page.headers.get('Content-Type')).toContain('javascript');
  child.kill('SIGINT');
  await closed;
  expect(said).not.toMatch(/failed|error TS/);
});
