/** A drape must have the same bytes on all platforms. */
import {execFileSync} from 'node:child_process';
import {mkdtempSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {fileURLToPath} from 'node:url';

import {drape, solve} from 'seamwise/node';
import {expect, it} from 'vitest';

import {checks, sample} from '../../support/garments/samples.js';

/** Program built with the native tests. */
const native = fileURLToPath(
  new URL('../../../build/native/tests/native/seamwise_drape', import.meta.url),
);

const bytesOf = (positions: Float64Array) =>
  Buffer.from(positions.buffer, positions.byteOffset, positions.byteLength);

const compared = ['tee', 'six-gore-skirt', 'patchwork-jacket', 'box-pleated-skirt'] as const;

it.each(compared)('of %s are those of a native program', {tags: ['thorough']}, async (name) => {
  const result = await solve({garment: sample(name), print: checks});
  const folder = mkdtempSync(join(tmpdir(), 'seamwise-'));
  try {
    const file = join(folder, 'result.json');
    writeFileSync(file, JSON.stringify(result));
    const expected = execFileSync(native, [file], {maxBuffer: 1 << 24});
    const {positions} = await drape(result);
    expect(bytesOf(positions).equals(expected)).toBe(true);
  } finally {
    rmSync(folder, {recursive: true});
  }
});
