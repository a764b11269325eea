/** How the pages of tests are built: relative addresses, no public files. */
import {defineConfig} from 'vite';

export default defineConfig({base: './', publicDir: false, build: {emptyOutDir: true}});
