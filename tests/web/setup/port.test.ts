/** `npm start` and `npm run dev` reject a port that cannot be opened with one sentence. */
import {execFile} from 'node:child_process';
import {once} from 'node:events';
import {createServer, type AddressInfo} from 'node:net';
import {fileURLToPath} from 'node:url';

import {expect, it, onTestFinished} from 'vitest';

interface End {
  readonly code: number | null;
  readonly said: string;
}

const end = (script: string, port: string): Promise<End> =>
  new Promise((resolve) => {
    const file = fileURLToPath(new URL(`../../../web/setup/${script}.mjs`, import.meta.url));
    const env = {...process.env, PORT: port};
    const child = execFile(process.execPath, [file], {env}, (_, out, err) => {
      resolve({code: child.exitCode, said: out + err});
    });
  });

it.each(['start', 'dev'])('%s rejects words that are no port', async (script) => {
  for (const port of ['0', '65536', 'abc', '']) {
    expect(await end(script, port)).toEqual({
      code: 1,
      said: `PORT is '${port}', but must be a number from 1024 to 65535.\n`,
    });
  }
});

it.each(['start', 'dev'])('%s rejects a port in use', async (script) => {
  const other = createServer().listen(0, 'localhost');
  onTestFinished(() => {
    other.close();
  });
  await once(other, 'listening');
  const {port} = other.address() as AddressInfo;
  expect(await end(script, String(port))).toEqual({
    code: 1,
    said: `Port ${port} is in use; choose another, such as PORT=5174.\n`,
  });
});
