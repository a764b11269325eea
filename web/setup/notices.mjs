import {copyFileSync, existsSync, readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';

import {root} from './shell.mjs';

/** Lies beside whatever is passed on. */
export const noticesFile = 'THIRD-PARTY-NOTICES.md';

/** Vite writes the licences of the packages in a bundle; this puts those of Seamwise and of its module around them. */
export function notices() {
  return {
    name: 'seamwise-notices',
    apply: 'build',
    config: () => ({build: {license: {fileName: noticesFile}}}),
    writeBundle({dir}) {
      const file = join(dir, noticesFile);
      const bundled = readFileSync(file, 'utf8').trim().replace(/^# .*/, '## In the scripts');
      const own = readFileSync(join(root, 'LICENSE'), 'utf8').trim();
      const module = readFileSync(join(root, 'web/setup/notices/module.md'), 'utf8').replace(
        '### Eigen\n',
        `### Eigen${eigenVersion()}\n`,
      );
      const heading = '# Licences of Seamwise and of what is in it';
      writeFileSync(file, `${heading}\n\n## Seamwise\n\n${own}\n\n${bundled}\n\n${module}`);
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
