import {describe, expect, it, vi} from 'vitest';

import type {Design} from '@/model/design/design.js';
import {writeProject} from '@/model/documents/write-project.js';
import {written} from '@/model/design/written-design.js';
import {garmentsIn} from '@/workbench/marker/garment-sources.js';
import {
  addedFrom,
  addGarments,
  removeGarment,
  setCopies,
} from '@/workbench/marker/garment-steps.js';
import {bareFabric, newDesign} from '@/workbench/samples.js';
import type {Workbench} from '@/workbench/workbench.js';

const garment = (name: string) => ({name, text: '{"pattern": {}}'});
const family: Design = {
  ...newDesign(garment('a.json'), bareFabric),
  copies: 2,
  added: addedFrom(newDesign(garment('b.json'), bareFabric)),
};

const documentOf = vi.fn(() => Promise.resolve({}));
const named = async (text: string) =>
  (
    await garmentsIn({name: 'x.json', size: text.length, text: () => Promise.resolve(text)}, {
      solving: {documentOf},
    } as unknown as Workbench)
  )?.map((one) => [one.garment.name, one.copies]);

describe('garments in a file', () => {
  it('are those of a project or a result, in their numbers of copies', async () => {
    const all = [
      ['a.json', 2],
      ['b.json', 1],
    ];
    expect(await named(writeProject(family))).toEqual(all);
    const result = {format: 'seamwise-result/1', design: written(family)};
    expect(await named(JSON.stringify(result))).toEqual(all);
    expect(documentOf).not.toHaveBeenCalled();
  });

  it('are the garment itself once it can be read, and none in other files', async () => {
    expect(await named('{"pattern": {}}')).toEqual([['x.json', 1]]);
    expect(documentOf).toHaveBeenCalledTimes(1);
    expect(await named('{"group": "p1", "w1": [1, 0], "w2": [0, 1]}')).toBeUndefined();
    expect(await named('no JSON')).toBeUndefined();
    expect(await named('{"design": {}}')).toBeUndefined();
  });
});

it('changes the garments of a design by steps, up to a limit', () => {
  let design = family;
  const history = {
    get design() {
      return design;
    },
    change: (change: Partial<Design>) => {
      design = {...design, ...change};
    },
  };
  const source = {history} as unknown as Workbench;
  const names = () => design.added?.map((one) => `${one.garment.name} ${one.copies}`);
  expect(addGarments(source, addedFrom(family))).toBe(2);
  setCopies(source, 1, 3);
  setCopies(source, 0, 4);
  expect([design.copies, names()]).toEqual([4, ['b.json 3', 'a.json 2', 'b.json 1']]);
  removeGarment(source, 2);
  expect(names()).toEqual(['b.json 3', 'b.json 1']);
  const many = Array.from({length: 12}, () => addedFrom(family)).flat();
  expect(addGarments(source, many)).toBe(18);
});
