import {fileURLToPath} from 'node:url';

import {defineConfig} from 'vitest/config';

const at = (path: string): string => fileURLToPath(new URL(path, import.meta.url));

export default defineConfig({
  // tests name sources by their rooms, as in tsconfig.json
  resolve: {alias: {'@/': at('web/src/'), '@samples/': at('web/samples/')}},
  test: {
    include: ['tests/**/*.test.ts'],
    testTimeout: 120_000,
    hookTimeout: 240_000,
    // parts of the page draw when there is time: a second is short on two cores that also compile
    expect: {poll: {timeout: 10_000}},
  },
});
