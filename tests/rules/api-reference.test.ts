import {execFile} from 'node:child_process';
import {mkdtemp, rm} from 'node:fs/promises';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {fileURLToPath} from 'node:url';
import {promisify} from 'node:util';

import {expect, it} from 'vitest';

import {tool} from '../../web/setup/shell.mjs';
import {isThorough} from '../support/level.js';

const project = fileURLToPath(new URL('../..', import.meta.url));

// a warning is an error: a type that is not exported, a broken link
it.runIf(isThorough)(
  'can be generated from the sources without a warning',
  {timeout: 300_000},
  async () => {
    const [node, typedoc] = tool('typedoc');
    const out = await mkdtemp(join(tmpdir(), 'seamwise-api-'));
    const args = [typedoc, '--out', out, '--logLevel', 'Warn'];
    const said = await promisify(execFile)(node, args, {cwd: project}).then(
      ({stdout}) => stdout,
      (error: unknown) => (error as {stdout: string; stderr: string}).stderr || String(error),
    );
    await rm(out, {recursive: true});
    expect(said).toBe('');
  },
);
