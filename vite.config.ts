/** Builds the page to build/page, with the samples of public/ beside it. */
import {createHash} from 'node:crypto';
import {readdirSync, readFileSync} from 'node:fs';
import {fileURLToPath} from 'node:url';

import {defineConfig, type Plugin} from 'vite';

import {leanThree} from './web/setup/lean-three.mjs';
import {notices, workerNotices} from './web/setup/notices.mjs';
import {shortTemplates} from './web/setup/short-templates.mjs';

const at = (path: string): string => fileURLToPath(new URL(path, import.meta.url));
const port = Number(process.env.PORT ?? 5173);

/** No other origins, no inline script or style, no eval; images may also be the user's own. */
const policy = [
  "default-src 'none'",
  "script-src 'self' 'wasm-unsafe-eval'",
  "worker-src 'self'",
  "style-src 'self'",
  "img-src 'self' data: blob:",
  "connect-src 'self'",
  "font-src 'self'",
  "manifest-src 'self'",
  "base-uri 'none'",
  "form-action 'self'",
].join('; ');

/**
 * Top-level files of public/; the service worker caches garments and prints only once they are
 * shown.
 */
const publicFiles = readdirSync(at('public'), {withFileTypes: true})
  .filter((entry) => entry.isFile())
  .map(({name}) => name);

/** The service worker for offline use, with the names of all files of the page. */
function offline(): Plugin {
  const fileName = 'service-worker.js';
  return {
    name: 'seamwise-offline',
    apply: 'build',
    enforce: 'post',
    buildStart() {
      this.emitFile({type: 'chunk', id: at('web/src/app/offline/service-worker.ts'), fileName});
    },
    generateBundle: {
      order: 'post',
      handler(_, bundle) {
        const worker = bundle[fileName];
        if (worker?.type !== 'chunk') return;
        const hash = createHash('sha256');
        for (const [name, file] of Object.entries(bundle).sort()) {
          hash.update(name).update(file.type === 'chunk' ? file.code : file.source);
        }
        for (const name of publicFiles) hash.update(readFileSync(at(`public/${name}`)));
        const built = Object.keys(bundle).filter((name) => name !== fileName);
        const files = ['./', ...built, ...publicFiles];
        const version = hash.digest('hex').slice(0, 12);
        worker.code = `self.seamwiseFiles=${JSON.stringify(files)};self.seamwiseVersion="${version}";${worker.code}`;
      },
    },
  };
}

/** A separate file for the drawing library, so that the size of the page's own code is visible. */
const drawing = {name: 'three', test: /node_modules[\\/]three[\\/]/, priority: 1};

/**
 * One file for the code shared by flat view, drape and lens, instead of one for each pair of them.
 */
const shared = {
  name: 'viewer',
  test: /[\\/]src[\\/]viewer[\\/]/,
  minShareCount: 2,
};

/** One file for the page's initial code, including parts that later chunks share. */
const opening = {
  name: 'page',
  tags: ['$initial'] as '$initial'[],
  test: (id: string) => !id.endsWith('service-worker.ts'),
};

export default defineConfig({
  root: at('web'),
  base: './',
  appType: 'mpa', // a missing file is an error, not the page
  publicDir: at('public'),
  plugins: [notices(), shortTemplates(), leanThree(), offline()],
  optimizeDeps: {entries: ['index.html']}, // excludes the examples
  server: {port, strictPort: true, fs: {allow: [at('.')]}},
  preview: {port, strictPort: true, headers: {'Content-Security-Policy': policy}},
  build: {
    outDir: at('build/page'),
    emptyOutDir: true,
    target: 'es2022',
    modulePreload: {polyfill: false},
    assetsInlineLimit: 0,
    chunkSizeWarningLimit: 600, // the drawing library
    rolldownOptions: {output: {codeSplitting: {groups: [drawing, opening, shared]}}},
  },
  worker: {format: 'es', plugins: () => [workerNotices()]},
});
