/** Pages of the site in reading order, in groups by reader. */
import type {DefaultTheme} from 'vitepress';

type Group = Omit<DefaultTheme.SidebarItem, 'items'> & {
  readonly text: string;
  /** Title and address of each page; the first page opens from the navigation bar. */
  readonly items: [DefaultTheme.SidebarItem, ...DefaultTheme.SidebarItem[]];
};

const page = (text: string, name: string): DefaultTheme.SidebarItem => ({text, link: `/${name}`});

const start: Group = {
  text: 'Start',
  items: [page('Installation', 'install'), page('Gallery', 'gallery'), page('Try it', 'live')],
};

/** Groups of readers, also the entries of the navigation bar. */
const readers: readonly Group[] = [
  {
    text: 'On the page',
    items: [
      page('The page', 'page'),
      page('Photo', 'photo'),
      page('Fabric layout', 'marker'),
      page('Cutting', 'cutting'),
      page('Prints', 'prints'),
    ],
  },
  {
    text: 'On the command line',
    items: [
      page('Commands', 'command-line'),
      page('Batch', 'batch'),
      page('Methods', 'methods'),
      page('Formats', 'formats'),
    ],
  },
  {
    text: 'In a product',
    items: [
      page('Embedding', 'embedding'),
      page('Frameworks and bundlers', 'frameworks'),
      page('JavaScript', 'javascript'),
      page('Example: a shop', 'examples/shop'),
      page('Example: Vite', 'examples/vite'),
    ],
  },
  {
    text: 'How it works',
    items: [
      page('The life of a print', 'life-of-a-print'),
      page('Inside the page', 'page-internals'),
      {
        text: 'Mathematics',
        link: '/mathematics',
        items: [
          page('Search and proof', 'mathematics-search'),
          page('Shaping', 'mathematics-shaping'),
          page('Drape', 'mathematics-drape'),
          page('Fabric layout', 'mathematics-layout'),
          page('Photo', 'mathematics-photo'),
        ],
      },
      page('Benchmarks', 'benchmarks'),
      page('Experiments', 'experiments'),
    ],
  },
  {
    text: 'Contribute',
    items: [
      page('Contributing', 'contributing'),
      page('Glossary', 'glossary'),
      page('Changelog', 'changelog'),
    ],
  },
];

/** The list of all pages beside every page. */
export const sidebar: DefaultTheme.SidebarItem[] = [start, ...readers];

/** The navigation bar. */
export const nav: DefaultTheme.NavItem[] = [
  ...start.items.slice(1).map(({text = '', link = ''}) => ({text, link})),
  ...readers.map(({text, items: [first, ...others]}) => ({
    text,
    link: first.link ?? '/',
    activeMatch: `^/(?:${[first, ...others].flatMap(addresses).join('|')})(?:\\.html)?$`,
  })),
];

/** Addresses of a page and of the pages below it, without the slash at the beginning. */
export function addresses({link = '', items = []}: DefaultTheme.SidebarItem): string[] {
  return [...(link === '' ? [] : [link.slice(1)]), ...items.flatMap(addresses)];
}
