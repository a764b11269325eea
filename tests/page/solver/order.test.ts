import {order, sha256Of, type FiledDesign} from 'seamwise/node';
import {expect, it} from 'vitest';

import {tee, useSolverPage} from '../../support/page/solver-page.js';

const openPage = useSolverPage();
const texts = {garment: tee.garment as string, print: tee.print as string};
const problem: FiledDesign = {
  garment: {url: 'tee.json', sha256: sha256Of(texts.garment)},
  print: {url: 'p4m.json', sha256: sha256Of(texts.print)},
  symmetry: 'auto',
  method: 'best',
  options: {},
  seed: 1,
};
const shelf = new Map([
  ['tee.json', texts.garment],
  ['p4m.json', texts.print],
]);
const read = (url: string) => Promise.resolve(new TextEncoder().encode(shelf.get(url)));

it.each<[string, Partial<FiledDesign['print']>]>([
  ['as the shop has it', {}],
  ['turned and resized', {turnDeg: 33, size: {width: 7.7, height: 7.7, angleDeg: 90}}],
])('an order in Node gives the bytes that a browser sold, the print %s', async (_, changes) => {
  const page = await openPage();
  const chosen = {...problem, print: {...problem.print, ...changes}};
  const sold = await page.evaluate(
    async ([choice, files]) => {
      const {designOf, problemOfStored} = globalThis.stored;
      return designOf(choice, await new Client().solve(problemOfStored(choice, files)));
    },
    [chosen, texts] as const,
  );
  await page.close();
  const {reproduced, text} = await order(sold, {read});
  expect(reproduced).toBe(true);
  expect(sha256Of(text)).toBe(sold.result);
});
