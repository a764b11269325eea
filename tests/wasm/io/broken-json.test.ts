/** JavaScript reads the texts, but its error messages must equal those of native programs. */
import {readFileSync} from 'node:fs';

import {convert} from 'seamwise/node';
import {expect, it} from 'vitest';

const file = new URL('../../fixtures/broken-json.json', import.meta.url);
const cases = JSON.parse(readFileSync(file, 'utf8')) as readonly {
  readonly text: string;
  readonly says: string;
}[];

it.each(cases)('says of $text that it $says', async ({text, says}) => {
  const bytes = new TextEncoder().encode(text) as unknown as string; // bytes, as read from a file
  await expect(convert(bytes, 'shirt.json')).rejects.toThrow(`shirt.json ${says}`);
});

it('refuses what is too large, by bytes and by values', async () => {
  await expect(convert(' '.repeat(20_000_001))).rejects.toThrow('larger than 20 MB');
  await expect(convert('é'.repeat(10_000_001))).rejects.toThrow('larger than 20 MB');
  await expect(convert('é'.repeat(9_000_000))).rejects.toThrow('unexpected characters');
  await expect(convert(`[${'0,'.repeat(3_000_001)}0]`)).rejects.toThrow('3 million values');
  await expect(convert('['.repeat(1_000_000))).rejects.toThrow('nests');
});

it('refuses halves of characters, which are no text', async () => {
  for (const half of ['\ud83d', '\ude00']) {
    await expect(convert(`{"a${half}b": 1}`)).rejects.toThrow('line 1, column 4');
  }
});
