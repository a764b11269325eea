/** Links between files of the project, as links of the site. */
import {copyFileSync, existsSync, mkdirSync, statSync} from 'node:fs';
import {dirname, join, posix, relative} from 'node:path';
import {fileURLToPath} from 'node:url';

import type {MarkdownRenderer} from 'vitepress';

/** The project's folder. */
export const root = fileURLToPath(new URL('../..', import.meta.url));

/** The page of a Markdown file, both as paths: `docs/page.md` is the page `page.md`. */
export function pageOf(file: string): string {
  if (file === 'README.md') return 'index.md';
  const name = file.replace(/^docs\//, '').replace(/^web\//, '');
  return name.replace(/\/README\.md$/, '.md').toLowerCase();
}

/** Files that pages link to and that are no pages. They are copied into the site. */
export class LinkedFiles {
  readonly #files = new Set<string>();
  readonly #base: string;

  /** @param base  path of the site on its host, such as `/` */
  constructor(base: string) {
    this.#base = base;
  }

  /**
   * Returns the address of the file or page that a link leads to.
   * @param from  file with the link, relative to the project's folder
   * @throws {Error} if the file is missing
   */
  address(link: string, from: string): {readonly href: string; readonly isFile: boolean} {
    const [path = '', hash] = link.split('#');
    if (path === '' || /^(?:[a-z]+:|\/)/i.test(path)) return {href: link, isFile: false};
    const file = posix.join(posix.dirname(from), decodeURI(path));
    if (!existsSync(join(root, file)) || !statSync(join(root, file)).isFile()) {
      throw new Error(`${from} links to ${link}, but ${file} is not a file; correct the link.`);
    }
    const end = hash === undefined ? '' : `#${hash}`;
    if (file.endsWith('.md')) return {href: `/${pageOf(file)}${end}`, isFile: false};
    this.#files.add(file);
    return {href: `${this.#base}files/${file}${end}`, isFile: true};
  }

  /** Copies the files to which pages link into the folder `files` of a site. */
  copyTo(site: string): void {
    for (const file of this.#files) {
      const target = join(site, 'files', file);
      mkdirSync(dirname(target), {recursive: true});
      copyFileSync(join(root, file), target);
    }
  }

  /** Adds the change of links to a Markdown renderer. */
  readonly useIn = (markdown: MarkdownRenderer): void => {
    markdown.core.ruler.push('seamwise-links', ({tokens, env}) => {
      const {realPath, path} = env as {readonly realPath?: string; readonly path: string};
      const from = relative(root, realPath ?? path);
      for (const token of tokens.flatMap(({children}) => children ?? [])) {
        const link = token.type === 'link_open' ? token.attrGet('href') : null;
        if (link === null) continue;
        const {href, isFile} = this.address(link, from);
        token.attrSet('href', href);
        if (isFile) token.attrSet('target', '_self'); // not a page for the router
      }
    });
  };
}
