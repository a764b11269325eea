/** The page: built into build/page, with the samples of public/ beside it. */
import {fileURLToPath} from 'node:url';

import {defineConfig} from 'vite';

const at = (path: string): string => fileURLToPath(new URL(path, import.meta.url));

export default defineConfig({
  root: at('web'),
  base: './',
  publicDir: at('public'),
  server: {port: 5173, strictPort: true, fs: {allow: [at('.')]}},
  build: {
    outDir: at('build/page'),
    emptyOutDir: true,
    target: 'es2022',
    modulePreload: {polyfill: false},
    assetsInlineLimit: 0,
  },
  worker: {format: 'es'},
});
