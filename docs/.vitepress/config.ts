/**
 * The documentation site: the files of docs and other Markdown files of the project, built into
 * build/site. The samples of public/ and the standalone script of the package are part of it.
 */
import {cpSync} from 'node:fs';
import {join} from 'node:path';

import {defineConfig, type HeadConfig} from 'vitepress';

import {siteNotices} from '../../web/setup/notices.mjs';
import {LinkedFiles, pageOf, root} from './links.js';
import {nav, sidebar} from './navigation.js';

/** Path of the site on its host. */
const base = `/${process.env.SITE_BASE ?? ''}/`.replaceAll(/\/+/g, '/');
const linked = new LinkedFiles(base);

/** The anchor of a heading, as on GitHub. */
const anchor = (heading: string): string =>
  heading
    .trim()
    .toLowerCase()
    .replaceAll(/[^\p{L}\p{N}\s_-]/gu, '')
    .replaceAll(/\s/g, '-');

const icon: HeadConfig = ['link', {rel: 'icon', href: `${base}icon.svg`, type: 'image/svg+xml'}];

export default defineConfig({
  title: 'Seamwise',
  description: 'Fits a repeating print to a sewing pattern so that it continues across the seams.',
  base,
  head: [icon],
  srcDir: root,
  srcExclude: ['!(docs|web)/**/*', 'web/!(examples)/**/*', 'README.md'],
  rewrites: pageOf,
  outDir: join(root, 'build/site'),
  cacheDir: join(root, 'build/vitepress'),
  markdown: {config: linked.useIn, anchor: {slugify: anchor}},
  buildEnd: ({outDir}) => {
    linked.copyTo(outDir);
    cpSync(join(root, 'dist/standalone'), join(outDir, 'seamwise'), {recursive: true});
  },
  vite: {
    configFile: false, // not that of the page
    plugins: [siteNotices()],
    build: {chunkSizeWarningLimit: 1000}, // the index of the search
  },
  themeConfig: {
    logo: '/icon.svg',
    nav,
    sidebar,
    outline: [2, 3],
    search: {provider: 'local'},
  },
});
