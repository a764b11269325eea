/** Every build for distribution lists the packages in it, with their licences. */
import {mkdtemp, readFile, rm} from 'node:fs/promises';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {fileURLToPath} from 'node:url';

import {build, type Plugin} from 'vite';
import {afterAll, beforeAll, describe, expect, it} from 'vitest';

import {noticesFile} from '../../web/setup/notices.mjs';

const project = fileURLToPath(new URL('../..', import.meta.url));

/** Adds the packages of a bundle's modules to `names`. */
const listing = (names: Set<string>): Plugin => ({
  name: 'packages',
  generateBundle: (_, bundle) => {
    for (const file of Object.values(bundle)) {
      const modules = file.type === 'chunk' ? file.moduleIds : [];
      for (const id of modules) {
        const name = /.*[\\/]node_modules[\\/]((?:@[^\\/]+[\\/])?[^\\/]+)/.exec(id)?.[1];
        if (name !== undefined) names.add(name.replace('\\', '/'));
      }
    }
  },
});

describe.each([
  {
    config: 'vite.config.ts',
    known: ['three', 'lit', 'clipper2-ts', 'idb', 'svgpath', 'pdfjs-dist'],
  },
  {config: 'vite.standalone.config.ts', known: ['three', 'lit', '@noble/hashes']},
])('what $config builds', ({config, known}) => {
  let folder = '';
  let text = '';
  const names = new Set<string>();

  beforeAll(async () => {
    folder = await mkdtemp(join(tmpdir(), 'seamwise-notices-'));
    await build({
      configFile: join(project, config),
      logLevel: 'error',
      plugins: [listing(names)],
      worker: {plugins: () => [listing(names)]},
      build: {outDir: folder, emptyOutDir: true, minify: false},
    });
    text = await readFile(join(folder, noticesFile), 'utf8');
  });

  afterAll(() => rm(folder, {recursive: true}));

  it('names each package that is in it, with its version and its licence', async () => {
    expect([...names]).toEqual(expect.arrayContaining(known));
    for (const name of names) {
      const manifest = await readFile(join(project, 'node_modules', name, 'package.json'), 'utf8');
      const {version, license} = JSON.parse(manifest) as {version: string; license: string};
      const heading = `## ${name} - ${version} (${license})\n`;
      expect(text).toContain(heading);
      const words = text.slice(text.indexOf(heading) + heading.length).split('\n## ')[0];
      expect(words, name).toMatch(/copyright|warranty/i);
    }
  });

  it("names Seamwise and what the solver's module is made of", () => {
    expect(text).toContain('Seamwise contributors');
    expect(text).toMatch(/### Eigen \d+\.\d+\.\d+\n[^#]*Mozilla Public License/);
    expect(text).toMatch(/## Letters of Liberation Sans[^#]*SIL OPEN FONT LICENSE/);
    for (const name of ['musl', 'Emscripten', 'libc++']) expect(text).toContain(`### ${name}`);
  });
});
