// Writes synthetic photographs of prints whose truth is known:
//   node tests/support/photo/write-cases.mjs FOLDER SEED NORMALS
import {fileURLToPath} from 'node:url';

import {runnerImport} from 'vite';

const at = (path) => fileURLToPath(new URL(path, import.meta.url));
const [folder = 'out/cases', seed = '1', normals = '3'] = process.argv.slice(2);

const {module} = await runnerImport(at('write-cases.ts'), {
  configFile: false,
  resolve: {alias: {'@/': at('../../../web/src/')}},
});
await module.writeCases(folder, Number(seed), Number(normals));
