/** The documentation site: every page is in its navigation, and no link is dead. */
import {readdirSync, readFileSync} from 'node:fs';
import {join, posix} from 'node:path';
import {fileURLToPath} from 'node:url';

import {expect, it} from 'vitest';

import {LinkedFiles, pageOf} from '../../../docs/.vitepress/links.js';
import {addresses, nav, sidebar} from '../../../docs/.vitepress/navigation.js';
import {build} from '../../../web/setup/build.mjs';

const root = fileURLToPath(new URL('../../..', import.meta.url));

it('lists every page of docs in its navigation', () => {
  const pages = readdirSync(join(root, 'docs'))
    .filter((name) => name.endsWith('.md') && name !== 'index.md')
    .map((name) => name.replace('.md', ''));
  const listed = sidebar.flatMap(addresses);
  expect(pages.filter((page) => !listed.includes(page))).toEqual([]);
});

it.each([
  ['docs/batch.md', true],
  ['docs/mathematics-drape.md', true],
  ['CONTRIBUTING.md', true],
  ['docs/index.md', false],
])('%s: is below an entry of the navigation bar: %s', (file, isBelow) => {
  const address = `/${pageOf(file).replace('.md', '')}`;
  const patterns = nav.flatMap((entry) => ('activeMatch' in entry ? [entry.activeMatch] : []));
  expect(patterns.some((pattern) => new RegExp(pattern).test(address))).toBe(isBelow);
});

it.each([
  ['page.md#drape', 'docs/install.md', '/page.md#drape'],
  ['../CONTRIBUTING.md', 'docs/install.md', '/contributing.md'],
  ['web/examples/shop/README.md', 'CONTRIBUTING.md', '/examples/shop.md'],
  ['../README.md', 'docs/page.md', '/index.md'],
  ['groups.svg', 'docs/prints.md', '/base/files/docs/groups.svg'],
  ['https://example.org/a.md', 'docs/page.md', 'https://example.org/a.md'],
  ['#drape', 'docs/page.md', '#drape'],
])('%s in %s leads to %s', (link, from, href) => {
  expect(new LinkedFiles('/base/').address(link, from).href).toBe(href);
});

it('rejects a link to a missing file', () => {
  expect(() => new LinkedFiles('/').address('none.svg', 'docs/page.md')).toThrow(
    'docs/page.md links to none.svg, but docs/none.svg is not a file; correct the link.',
  );
});

it(
  'has no dead link, no dead anchor and nothing of another host',
  {tags: ['thorough'], timeout: 300_000},
  async () => {
    await build('site');
    const site = join(root, 'build/site');
    const files = readdirSync(site, {recursive: true, withFileTypes: true})
      .filter((entry) => entry.isFile())
      .map(({parentPath, name}) => join(parentPath, name).slice(site.length));
    const pages = new Map(
      files
        .filter((file) => file.endsWith('.html'))
        .map((file) => [file, readFileSync(join(site, file), 'utf8')]),
    );
    const dead = [...pages].flatMap(([page, html]) =>
      [...html.matchAll(/\b(?:href|src)="([^"]+)"/g)]
        .map(([, link = '']) => link)
        .filter((link) => !/^(?:https?|data|mailto):/.test(link))
        .filter((link) => {
          const [path = '', anchor] = link.split('#');
          const target = path === '' ? page : posix.resolve(posix.dirname(page), path);
          const file = path.endsWith('/') ? posix.join(target, 'index.html') : target;
          if (!files.includes(file)) return true;
          return anchor !== undefined && !pages.get(file)?.includes(`id="${decodeURI(anchor)}"`);
        })
        .map((link) => `${page}: ${link}`),
    );
    expect(dead).toEqual([]);
    const loaded = /<(?:script|link|img|iframe)\b[^>]*(?:src|href)="(?:https?:)?\/\//;
    expect([...pages.keys()].filter((page) => loaded.test(pages.get(page) ?? ''))).toEqual([]);
  },
);
