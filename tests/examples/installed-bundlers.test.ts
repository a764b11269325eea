/**
 * Bundlers that are not part of this project, set up by the words of docs/frameworks.md. They are
 * installed from the registry; without it the tests are left out.
 */
import {cp, readFile, writeFile} from 'node:fs/promises';
import {join} from 'node:path';

import {expect, it} from 'vitest';

import {guide, inShell, isOnline, ownFiles, useProjects} from '../support/package/projects.js';

const {projectWith, works} = useProjects();

const page = `<!doctype html><link rel="icon" href="icon.svg" /><script type="module" src="./main.js"></script>
  <seamwise-garment loading="eager" garment="garments/tee-m.json" print="prints/p4m.json"></seamwise-garment>`;
const files = {'main.js': "import 'seamwise/element/auto';\n", 'index.html': page};

/** Commands of the guide's shell examples that begin with these words. */
const commandsOf = (words: string): readonly string[] =>
  [...guide.matchAll(/^```sh\n([^]*?)^```$/gm)]
    .flatMap(([, code = '']) => code.trim().split('\n'))
    .filter((line) => line.startsWith(words));

it.runIf(isOnline)('works with webpack without any configuration', async () => {
  const folder = await projectWith(['webpack@5', 'webpack-cli@7'], files);
  await inShell(folder, 'npx webpack --mode production --entry ./main.js -o public');
  await cp(join(folder, 'index.html'), join(folder, 'public/index.html'));
  await works(join(folder, 'public'));
});

it.runIf(isOnline).each(['esbuild', 'rollup'])('works with %s by the guide', async (name) => {
  const [install = ''] = commandsOf('npm install --save-dev rollup');
  const folder = await projectWith(name === 'esbuild' ? ['esbuild'] : [], files);
  if (name === 'rollup') await inShell(folder, install);
  const lines = [...commandsOf(`npx ${name}`), ...commandsOf('cp node_modules/seamwise')];
  expect(lines).toHaveLength(2);
  for (const line of lines) await inShell(folder, line);
  await cp(join(folder, 'index.html'), join(folder, 'public/index.html'));
  await works(join(folder, 'public'));
});

it.runIf(isOnline)('works with Parcel by the guide', async () => {
  const [, setting = ''] = /^\| Parcel 2.*\| `(.*)` in/m.exec(guide) ?? [];
  const folder = await projectWith(['parcel@2'], files);
  await writeFile(join(folder, 'package.json'), `{"name": "shop", "private": true, ${setting}}`);
  const plain = (await readFile(join(folder, 'index.html'), 'utf8')).replace(/<link[^>]*>/, '');
  await writeFile(join(folder, 'index.html'), plain);
  await inShell(folder, 'npx parcel build index.html --dist-dir assets');
  // Parcel makes an inline import map, and the page has no icon
  await works(join(folder, 'assets'), `${ownFiles} 'unsafe-inline'`, /status of 404/);
});

it.runIf(isOnline).each(['5', '6', '7'])('works with Vite %s by the guide', async (version) => {
  const [, setting = ''] = /^\| Vite 5, 6 and 7.*?\| `([^`]*)` in/m.exec(guide) ?? [];
  const config = `export default {${setting}};\n`;
  const folder = await projectWith([`vite@${version}`], {...files, 'vite.config.js': config});
  await inShell(folder, 'npx vite build --base ./');
  await works(join(folder, 'dist'));
});
