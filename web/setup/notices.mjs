import {copyFileSync, existsSync, readdirSync, readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';

import {root} from './shell.mjs';

/** Name of the file with the licences in every distribution. */
export const noticesFile = 'THIRD-PARTY-NOTICES.md';

/** Folders of packages bundled in workers, which Vite's own list leaves out. */
const inWorkers = new Set();

/** Plugin that lists the packages in bundles of workers. */
export function workerNotices() {
  return {
    name: 'seamwise-worker-notices',
    generateBundle(_, bundle) {
      for (const folder of packagesIn(bundle)) inWorkers.add(folder);
    },
  };
}

/**
 * Plugin that writes the licences of the packages in the scripts of the documentation site. They
 * are not in the package.
 */
export function siteNotices() {
  const folders = new Set();
  return {
    name: 'seamwise-site-notices',
    generateBundle(_, bundle) {
      for (const folder of packagesIn(bundle)) folders.add(folder);
    },
    writeBundle({dir}) {
      const own = readFileSync(join(root, 'LICENSE'), 'utf8').trim();
      const others = [...folders].map(noticeOf).sort();
      const parts = ['# Licences of this site', `## Seamwise\n\n${own}`, ...others];
      writeFileSync(join(dir, noticesFile), `${parts.join('\n\n')}\n`);
    },
  };
}

/** Folders of the packages in a bundle. */
function packagesIn(bundle) {
  const ids = Object.values(bundle).flatMap(({moduleIds}) => moduleIds ?? []);
  const folders = ids.map(
    (id) => /^.*[\\/]node_modules[\\/](?:@[^\\/]+[\\/])?[^\\/]+/.exec(id)?.[0],
  );
  return new Set(folders.filter((folder) => folder !== undefined));
}

/** A package's notice in Vite's format. */
function noticeOf(folder) {
  const {name, version, license} = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
  const file = readdirSync(folder).find((one) => /^licen[cs]e/i.test(one));
  const words = file === undefined ? '' : readFileSync(join(folder, file), 'utf8').trim();
  return `## ${name} - ${version} (${license})\n\n${words}`;
}

/**
 * Vite writes the licences of the packages in a bundle; this plugin adds those of Seamwise and of
 * its module.
 */
export function notices() {
  return {
    name: 'seamwise-notices',
    apply: 'build',
    config: () => ({build: {license: {fileName: noticesFile}}}),
    writeBundle({dir}, bundle) {
      const file = join(dir, noticesFile);
      const bundled = readFileSync(file, 'utf8').trim().replace(/^# .*/, '## In the scripts');
      const more = [...inWorkers]
        .map(noticeOf)
        .filter((notice) => !bundled.includes(headOf(notice)));
      const scripts = [bundled, ...more.sort()].join('\n\n');
      const own = readFileSync(join(root, 'LICENSE'), 'utf8').trim();
      const module = readFileSync(join(root, 'web/setup/notices/module.md'), 'utf8').replace(
        '### Eigen\n',
        `### Eigen${eigenVersion()}\n`,
      );
      const heading = '# Licences of Seamwise and of what is in it';
      const parts = [heading, `## Seamwise\n\n${own}`, scripts, ...fontNotices(bundle), module];
      writeFileSync(file, parts.join('\n\n'));
    },
  };
}

/** Licences of the typefaces in a bundle. */
function fontNotices(bundle) {
  const notice = (name, file) =>
    `## ${name} (OFL-1.1)\n\n${readFileSync(join(root, file), 'utf8').trim()}`;
  const hasFiles = Object.keys(bundle).some((name) => name.endsWith('.woff2'));
  return [
    ...(hasFiles ? [notice('Source Sans 3', 'web/src/app/fonts/OFL.txt')] : []),
    notice(
      'Letters of Liberation Sans, for PDF files',
      'node_modules/pdfjs-dist/standard_fonts/LICENSE_LIBERATION',
    ),
  ];
}

/** The first line of a notice up to the version. */
const headOf = (notice) => notice.slice(0, notice.indexOf(' - ') + 3);

/** Version of Eigen in the headers of the module's build; empty if they are elsewhere. */
function eigenVersion() {
  const file = join(root, 'build/wasm/include/Eigen/src/Core/util/Macros.h');
  if (!existsSync(file)) return '';
  const text = readFileSync(file, 'utf8');
  const parts = ['WORLD', 'MAJOR', 'MINOR'].map(
    (part) => new RegExp(`#define EIGEN_${part}_VERSION (\\d+)`).exec(text)?.[1],
  );
  return parts.includes(undefined) ? '' : ` ${parts.join('.')}`;
}

/** Copies the notices of the standalone script, which contains the package's packages. */
export function copyNotices() {
  copyFileSync(join(root, 'dist/standalone', noticesFile), join(root, 'dist', noticesFile));
}
