/**
 * A print of unknown size in the element: shown and aligned, but not cut until its file has a size.
 */
import {expect, it} from 'vitest';

import {useElementPage} from '../../support/page/element-page.js';

const openPage = useElementPage();

const garment =
  '<seamwise-garment garment="garments/tee-{size}.json" size="m" alt="A tee"></seamwise-garment>';

it(
  'is refused where files to cut or a length of fabric are asked for',
  {tags: ['thorough']},
  async () => {
    const {page, put, run} = await openPage();
    await put(garment);
    await run(async (element) => {
      const from = 'prints/p4m.json';
      const print = (await (await fetch(from)).json()) as {image: string};
      const image = new URL(print.image, new URL(from, document.baseURI)).href;
      element.print = {...print, image, title: 'Meadow', unscaled: true} as typeof element.print;
    });
    await page.locator('seamwise-garment:state(ready)').waitFor({timeout: 60_000});
    const heard = await run(async (element) => {
      element.clothWidth = 140;
      const refused = (work: Promise<unknown>): Promise<string> =>
        work.then(
          () => 'given',
          (error: unknown) => {
            const {code, message} = error as {code: string; message: string};
            return `${code}: ${message}`;
          },
        );
      return [
        await refused(element.toBlob({type: 'application/pdf', paper: 'a0'})),
        await refused(element.layPlan()),
      ];
    });
    for (const sentence of heard) {
      expect(sentence).toMatch(/^unscaled: The size of .*is unknown.*measure .*\.$/);
    }
  },
);
