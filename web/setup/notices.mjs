import {copyFileSync, existsSync, readdirSync, readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';

import {root} from './shell.mjs';

/** Lies beside whatever is passed on. */
export const noticesFile = 'THIRD-PARTY-NOTICES.md';

/** Packages of the workers that are bundled: Vite's own list leaves them out. */
const inWorkers = new Set();

/** For the bundles of workers. */
export function workerNotices() {
  return {
    name: 'seamwise-worker-notices',
    generateBundle(_, bundle) {
      for (const file of Object.values(bundle)) {
        for (const id of file.type === 'chunk' ? file.moduleIds : []) {
          const name = /.*[\\/]node_modules[\\/]((?:@[^\\/]+[\\/])?[^\\/]+)/.exec(id)?.[1];
          if (name !== undefined) inWorkers.add(name.replace('\\', '/'));
        }
      }
    },
  };
}

/** What a package says of itself, as Vite writes it. */
function noticeOf(name) {
  const folder = join(root, 'node_modules', name);
  const {version, license} = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
  const file = readdirSync(folder).find((one) => /^licen[cs]e/i.test(one));
  const words = file === undefined ? '' : readFileSync(join(folder, file), 'utf8').trim();
  return `## ${name} - ${version} (${license})\n\n${words}`;
}

/** Vite writes the licences of the packages in a bundle; this puts those of Seamwise and of its module around them. */
export function notices() {
  return {
    name: 'seamwise-notices',
    apply: 'build',
    config: () => ({build: {license: {fileName: noticesFile}}}),
    writeBundle({dir}) {
      const file = join(dir, noticesFile);
      const bundled = readFileSync(file, 'utf8').trim().replace(/^# .*/, '## In the scripts');
      const more = [...inWorkers].filter((name) => !bundled.includes(`## ${name} - `)).sort();
      const scripts = [bundled, ...more.map(noticeOf)].join('\n\n');
      const own = readFileSync(join(root, 'LICENSE'), 'utf8').trim();
      const module = readFileSync(join(root, 'web/setup/notices/module.md'), 'utf8').replace(
        '### Eigen\n',
        `### Eigen${eigenVersion()}\n`,
      );
      const heading = '# Licences of Seamwise and of what is in it';
      writeFileSync(file, `${heading}\n\n## Seamwise\n\n${own}\n\n${scripts}\n\n${module}`);
    },
  };
}

/** As the headers say that the module was built with; nothing where they are elsewhere. */
function eigenVersion() {
  const file = join(root, 'build/wasm/include/Eigen/src/Core/util/Macros.h');
  if (!existsSync(file)) return '';
  const text = readFileSync(file, 'utf8');
  const parts = ['WORLD', 'MAJOR', 'MINOR'].map(
    (part) => new RegExp(`#define EIGEN_${part}_VERSION (\\d+)`).exec(text)?.[1],
  );
  return parts.includes(undefined) ? '' : ` ${parts.join('.')}`;
}

/** The package holds what is in its standalone script, and that says so. */
export function copyNotices() {
  copyFileSync(join(root, 'dist/standalone', noticesFile), join(root, 'dist', noticesFile));
}
