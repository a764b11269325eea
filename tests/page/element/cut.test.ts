/** Cutting sheets from the element. */
import {expect, it} from 'vitest';

import {tee, useElementPage} from '../../support/page/element-page.js';

const openPage = useElementPage();

it('gives the pieces to cut as files, and says what it has not', async () => {
  const {page, put, run} = await openPage();
  await put(tee);
  await page.locator('seamwise-garment:state(ready)').waitFor();
  const given = await run(async (element) => {
    const types = ['application/pdf', 'image/svg+xml', 'application/dxf'];
    const blobs = await Promise.all(types.map((type) => element.toBlob({type, paper: 'a0'})));
    return Promise.all(
      blobs.map(async (blob) => [blob.type, (await blob.text()).slice(0, 5)] as const),
    );
  });
  expect(given).toEqual([
    ['application/pdf', '%PDF-'],
    ['image/svg+xml', '<svg '],
    ['application/dxf', expect.stringMatching(/^\s*(0|999)/)],
  ]);
  const heard = await run(async (element) => {
    const refused = (request: Parameters<typeof element.toBlob>[0]): Promise<string> =>
      element.toBlob(request).then(
        () => 'given',
        (error: unknown) => {
          const {code, message} = error as {code: string; message: string};
          return `${code}: ${message}`;
        },
      );
    const type = 'application/pdf';
    return Promise.all([refused({type, paper: 'b9'}), refused({type, allowance: -1})]);
  });
  expect(heard[0]).toMatch(/^options: .*'b9'/);
  expect(heard[1]).toBe('options: An allowance is 0 to 10 cm; choose a value in that range.');
});

it('has nothing to cut before there is an answer', {tags: ['thorough']}, async () => {
  const {run, put} = await openPage();
  await put('<seamwise-garment></seamwise-garment>');
  const heard = await run((element) =>
    element.toBlob({type: 'application/pdf'}).then(
      () => 'given',
      (error: unknown) => (error as {code: string}).code,
    ),
  );
  expect(heard).toBe('options');
});
