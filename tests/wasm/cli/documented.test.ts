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
/** A package of the same name resolves `seamwise/node` to `dist`, as in this project. */
const manifest = await readFile(join(project, 'package.json'), 'utf8');
let folder: string;

beforeAll(async () => {
  folder = await mkdtemp(join(tmpdir(), 'seamwise-guides-'));
  for (const part of ['public', 'dist', 'tests', 'node_modules']) {
    await symlink(join(project, part), join(folder, part), 'junction');
  }
  await writeFile(join(folder, 'package.json'), manifest);
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
    await inShell(line);
  }
  return lines.length;
}

/** Runs a command as it is written for this project's folder. */
const inShell = (command: string) => {
  const own = command.replaceAll('npm run -s seamwise --', program);
  return run('sh', ['-c', own.replaceAll(/^seamwise /gm, `${program} `)], {
    ...{cwd: folder, maxBuffer: 1e8},
  });
};

/** Output of a command, whatever its exit code. */
async function outputOf(command: string): Promise<string> {
  const {stdout, stderr} = await inShell(command).catch(
    (error: unknown) => error as {stdout: string; stderr: string},
  );
  return stdout + stderr;
}

/** Lines of an output without notes, with `#` for each number, which better solvers change. */
const summariesOf = (text: string): readonly string[] =>
  text
    .replaceAll(/\d+(\.\d+)?/g, '#')
    .replaceAll(/; (proven the shortest|# cm at the least)/g, '')
    .split('\n')
    .filter((line) => line !== '' && !line.startsWith('note: '));

/** Runs a guide's programs for Node. @returns their output */
const programsOf = async (guide: string): Promise<readonly string[]> =>
  Promise.all(
    (await snippetsOf(guide, 'js')).map(async (code, k) => {
      const file = join(folder, `program-${k}.mjs`);
      await writeFile(file, code);
      return (await run(process.execPath, [file], {cwd: folder})).stdout;
    }),
  );

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

it(
  'of the fabric layout print what the guide shows',
  {tags: ['thorough'], timeout: 600_000},
  async () => {
    const sessions = (await snippetsOf('docs/marker.md', 'console')).flatMap((text) =>
      text.split(/^\$ /m).filter((part) => part !== ''),
    );
    for (const session of sessions) {
      const [command = '', ...shown] = session.split('\n');
      expect(summariesOf(await outputOf(command)), command).toEqual(summariesOf(shown.join('\n')));
    }
    expect(sessions.length).toBeGreaterThan(15);
    const [printed] = await programsOf('docs/marker.md');
    expect(printed).toMatch(/^[\d.]+ (true|false)\n$/);
  },
);

it('of JavaScript run', {timeout: 240_000}, async () => {
  const [printed = ''] = await programsOf('docs/javascript.md');
  expect(printed).toContain('deformation 1\n');
});
