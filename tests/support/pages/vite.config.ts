/** Build settings of the tests' pages: relative addresses, no public files. */
import {defineConfig} from 'vite';

export default defineConfig({base: './', publicDir: false, build: {emptyOutDir: true}});
