/**
 * Builds the element with three and Lit inside, for pages without a bundler, to dist/standalone: a
 * script to load, with the files that it loads on demand. The build is not in Vite's library mode,
 * which would turn the .wasm file into a `data:` URL. All addresses are relative, so that the
 * folder works anywhere.
 */
import {fileURLToPath} from 'node:url';

import {defineConfig} from 'vite';

import {leanThree} from './web/setup/lean-three.mjs';
import {notices} from './web/setup/notices.mjs';
import {shortTemplates} from './web/setup/short-templates.mjs';

const at = (path: string): string => fileURLToPath(new URL(path, import.meta.url));

/** Files loaded by name keep their names; the others must not come from a cache after an update. */
const names = {
  entryFileNames: '[name].js',
  chunkFileNames: '[name]-[hash].js',
  assetFileNames: '[name][extname]',
};

export default defineConfig({
  root: at('.'),
  base: './',
  publicDir: false,
  plugins: [notices(), shortTemplates(), leanThree()],
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
            // one file for the initial code, including parts that later chunks share
            {name: 'opening', tags: ['$initial' as const]},
          ],
        },
      },
    },
  },
  // fixed names, because hosts copy the worker's files
  worker: {
    format: 'es',
    rolldownOptions: {output: {...names, chunkFileNames: 'solver.[name].js'}},
  },
});
