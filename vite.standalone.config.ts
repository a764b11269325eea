/**
 * The element with three and Lit inside, for pages without a bundler: built into dist/standalone, a script to load,
 * and beside it what that loads when it is needed. It is no library to Vite, which would turn the .wasm file into a
 * `data:` URL then; all addresses are relative, so that the folder may lie anywhere.
 */
import {fileURLToPath} from 'node:url';

import {defineConfig} from 'vite';

import {notices} from './web/setup/notices.mjs';
import {shortStyles} from './web/setup/short-styles.mjs';

const at = (path: string): string => fileURLToPath(new URL(path, import.meta.url));

/** What is loaded by name keeps its name; the rest must not be taken from a cache after an update. */
const names = {
  entryFileNames: '[name].js',
  chunkFileNames: '[name]-[hash].js',
  assetFileNames: '[name][extname]',
};

export default defineConfig({
  root: at('.'),
  base: './',
  publicDir: false,
  plugins: [notices(), shortStyles()],
  build: {
    outDir: at('dist/standalone'),
    emptyOutDir: true,
    target: 'es2022',
    modulePreload: false,
    assetsInlineLimit: 0,
    chunkSizeWarningLimit: 700, // the drawing library
    rolldownOptions: {
      input: {seamwise: at('web/src/element/auto.ts')},
      preserveEntrySignatures: 'exports-only',
      output: {
        ...names,
        codeSplitting: {
          groups: [
            {name: 'three', test: /node_modules[\\/]three[\\/]/, priority: 1},
            // all that it begins with is one file: what of it others share is none of its own
            {name: 'opening', tags: ['$initial' as const]},
          ],
        },
      },
    },
  },
  // also by name: hosts copy what the worker loads
  worker: {
    format: 'es',
    rolldownOptions: {output: {...names, chunkFileNames: 'solver.[name].js'}},
  },
});
