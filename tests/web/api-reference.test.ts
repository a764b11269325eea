import {execFile} from 'node:child_process';
import {fileURLToPath} from 'node:url';
import {promisify} from 'node:util';

import {expect, it} from 'vitest';

import {tool} from '../../web/setup/shell.mjs';

const project = fileURLToPath(new URL('../..', import.meta.url));

// what it complains of is an error: a type that is not exported, a link to nowhere
it('can be generated from the sources without a warning', {timeout: 300_000}, async () => {
  const [node, typedoc] = tool('typedoc');
  const said = await promisify(execFile)(node, [typedoc, '--emit', 'none'], {cwd: project}).then(
    () => '',
    (error: unknown) => (error as {stderr: string}).stderr,
  );
  expect(said).toBe('');
});
