import {expect, it} from 'vitest';

import {readAnyDrawing} from '@/files/read-drawing.js';
import {FileError} from '@/model/base/versioned-file.js';

import {cases} from '../../support/level.js';
import {pdfOf, tilesOf} from '../../support/files/drawn-pdf.js';
import {plainSheet} from '../../support/files/paper-patterns.js';

const text = Buffer.from(
  pdfOf(tilesOf(plainSheet(), {paper: [297, 420], margin: 10, overlap: 10})),
).toString('latin1');

/** A sequence of pseudo-random numbers from 0 to 1. */
function* numbers(seed: number): Generator<number, never> {
  for (let state = seed; ;) {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    yield state / 2 ** 32;
  }
}

/** Changes, repeats and drops some parts of a text. */
function damaged(seed: number): string {
  const random = numbers(seed);
  const next = (below: number): number => Math.floor(random.next().value * below);
  let result = text;
  for (let k = 1 + next(8); k > 0; k--) {
    const at = next(result.length);
    const length = next(next(3) === 0 ? 2000 : 6);
    const part = result.slice(at, at + length);
    const inserted = [
      '',
      part + part,
      String.fromCharCode(next(256)),
      '99999999999',
      '-1',
      '<<',
      ' cm ',
    ];
    result = result.slice(0, at) + (inserted[next(7)] ?? '') + result.slice(at + length);
  }
  return result;
}

it('reads damaged files, or refuses them in one sentence', async () => {
  for (let seed = 1; seed <= cases(10, 400); seed++) {
    const bytes = Uint8Array.from(Buffer.from(damaged(seed), 'latin1'));
    try {
      await readAnyDrawing(bytes, 'fuzzed.pdf');
    } catch (error) {
      if (!(error instanceof FileError)) throw new Error(`seed ${seed}`, {cause: error});
      expect(error.message, `seed ${seed}`).toMatch(/^fuzzed\.pdf [^\n]*\.$/);
    }
  }
});
