import {fileURLToPath} from 'node:url';

import {defineConfig} from 'vitest/config';

const at = (path: string): string => fileURLToPath(new URL(path, import.meta.url));

export default defineConfig({
  // tests name sources by their rooms, as in tsconfig.json
  resolve: {alias: {'@/': at('web/src/'), '@samples/': at('web/samples/')}},
  test: {include: ['tests/**/*.test.ts'], testTimeout: 120_000, hookTimeout: 240_000},
});
