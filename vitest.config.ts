import {fileURLToPath} from 'node:url';

import {defineConfig} from 'vitest/config';

const at = (path: string): string => fileURLToPath(new URL(path, import.meta.url));
const isThorough = process.env.SEAMWISE_TESTS === 'thorough';

export default defineConfig({
  // aliases of the source folders, as in tsconfig.json
  resolve: {alias: {'@/': at('web/src/'), '@samples/': at('web/samples/')}},
  test: {
    testTimeout: 120_000,
    setupFiles: ['tests/support/random-seed.ts'],
    hookTimeout: 240_000,
    // parts of the page render when there is time: a second is too short on two cores that also
    // compile
    tags: [
      {
        name: 'thorough',
        description: 'Left out by `npm test`; variants of what other tests check.',
      },
    ],
    expect: {poll: {timeout: 10_000}},
    // pdf.js rejects promises that nobody awaits in damaged files; its reader ignores them
    onUnhandledError: ({name}) => !/^(?:XRefEntry|ParserEOF)Exception$/.test(name ?? ''),
    projects: [
      {
        extends: true,
        test: {
          name: 'web',
          include: ['tests/{rules,web,wasm,package}/**/*.test.ts'],
          isolate: false,
        },
      },
      {
        extends: true,
        test: {
          name: 'browser',
          include: ['tests/{page,examples}/**/*.test.ts'],
          exclude: isThorough
            ? []
            : ['tests/examples/{bundlers,frameworks,installed-bundlers,other-browsers}.test.ts'],
          globalSetup: 'tests/support/page/start-browser.ts',
          isolate: false,
        },
      },
      {
        extends: true,
        test: {
          name: 'timing',
          include: ['tests/timing/**/*.test.ts'],
          globalSetup: 'tests/support/page/start-browser.ts',
          fileParallelism: false,
        },
      },
    ],
  },
});
