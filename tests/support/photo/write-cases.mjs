// Writes synthetic photos of prints with known truth:
//   node tests/support/photo/write-cases.mjs FOLDER SEED NORMALS [PART ...]
// NORMALS is the number of photos of each group at the level `normal`, and half of that of each object
// on the fabric. PART is normal, scan, hard, special, almost, covered, decoy or tile, all of which are
// written by default, or large: five of 12 megapixels, as JPEG files.
import {fileURLToPath} from 'node:url';

import {runnerImport} from 'vite';

const at = (path) => fileURLToPath(new URL(path, import.meta.url));
const [folder = 'out/cases', seed = '1', normals = '3', ...parts] = process.argv.slice(2);

const {module} = await runnerImport(at('write-cases.ts'), {
  configFile: false,
  resolve: {alias: {'@/': at('../../../web/src/')}},
});
await module.writeCases(
  folder,
  Number(seed),
  Number(normals),
  parts.length > 0 ? parts : undefined,
);
