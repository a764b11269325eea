/** The commands of the guides, run one after the other in a folder with the samples. */
import {execFile} from 'node:child_process';
import {copyFile, mkdtemp, readFile, rm, symlink, writeFile} from 'node:fs/promises';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {fileURLToPath} from 'node:url';
import {promisify} from 'node:util';

import {afterAll, beforeAll, expect, it} from 'vitest';

const run = promisify(execFile);
const project = fileURLToPath(new URL('../../..', import.meta.url));
const program = `${process.execPath} ${join(project, 'dist/cli/main.js')}`;
let folder: string;

beforeAll(async () => {
  folder = await mkdtemp(join(tmpdir(), 'seamwise-guides-'));
  await symlink(join(project, 'public'), join(folder, 'public'), 'junction');
});
afterAll(() => rm(folder, {recursive: true}));

/** Code examples of a guide in a language. */
async function snippetsOf(guide: string, language: string): Promise<readonly string[]> {
  const text = await readFile(join(project, guide), 'utf8');
  return [...text.matchAll(new RegExp(`^\`\`\`${language}\\n([^]*?)^\`\`\`$`, 'gm'))].map(
    ([, code = '']) => code,
  );
}

/** Runs the lines that contain any of these words. @returns the number of lines */
async function runAll(guide: string, words: RegExp): Promise<number> {
  const lines = (await snippetsOf(guide, 'sh'))
    .flatMap((code) => code.trim().split('\n'))
    .filter((line) => words.test(line));
  for (const line of lines) {
    const command = line.replace(/^npm run -s seamwise --/, program);
    await run('sh', ['-c', command], {cwd: folder, maxBuffer: 1e8});
  }
  return lines.length;
}

it('of the README run', async () => {
  expect(await runAll('README.md', /^mkdir|seamwise/)).toBe(3);
  expect(await readFile(join(folder, 'out/dress.svg'), 'utf8')).toContain('</svg>');
});

it('of the command line and of cutting run', {tags: ['thorough'], timeout: 600_000}, async () => {
  expect(await runAll('docs/command-line.md', /^mkdir|-- (?!photo|import)/)).toBeGreaterThan(10);
  await copyFile(join(folder, 'out/tee.json'), join(folder, 'out/tee-design.json'));
  await copyFile(join(folder, 'out/tee-result.json'), join(folder, 'out/tee.json'));
  expect(await runAll('docs/cutting.md', /seamwise/)).toBe(2);
});

it('of a batch run on its example of jobs', {tags: ['thorough'], timeout: 600_000}, async () => {
  const [jobs = ''] = await snippetsOf('docs/batch.md', 'json');
  await writeFile(join(folder, 'jobs.ndjson'), jobs);
  expect(await runAll('docs/batch.md', /jobs\.ndjson/)).toBe(1);
  const done = await readFile(join(folder, 'shelf/done.ndjson'), 'utf8');
  expect(done.trim().split('\n')).toHaveLength(3);
});
