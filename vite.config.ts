/** The page: built into build/page, with the samples of public/ beside it. */
import {fileURLToPath} from 'node:url';

import {defineConfig} from 'vite';

const at = (path: string): string => fileURLToPath(new URL(path, import.meta.url));
const port = Number(process.env.PORT ?? 5173);

/** Nothing from elsewhere, no inline script or style, no eval; pictures may also be the user's own. */
const policy = [
  "default-src 'none'",
  "script-src 'self' 'wasm-unsafe-eval'",
  "worker-src 'self'",
  "style-src 'self'",
  "img-src 'self' data: blob:",
  "connect-src 'self'",
  "base-uri 'none'",
  "form-action 'self'",
].join('; ');

export default defineConfig({
  root: at('web'),
  base: './',
  appType: 'mpa', // a file that is not there is an error, not the page
  publicDir: at('public'),
  server: {port, strictPort: true, fs: {allow: [at('.')]}},
  preview: {port, strictPort: true, headers: {'Content-Security-Policy': policy}},
  build: {
    outDir: at('build/page'),
    emptyOutDir: true,
    target: 'es2022',
    modulePreload: {polyfill: false},
    assetsInlineLimit: 0,
    chunkSizeWarningLimit: 600, // the drawing library
    // the drawing library apart, so that the page's own code can be seen for what it is
    rolldownOptions: {
      output: {codeSplitting: {groups: [{name: 'three', test: /node_modules[\\/]three[\\/]/}]}},
    },
  },
  worker: {format: 'es'},
});
