/** Odd arguments and properties of the element: it rejects them with a code and a sentence. */
import {expect, it} from 'vitest';

import {failureCodes, pageFailureCodes} from '@/model/base/failure.js';
import type {SeamwiseGarment} from '@/element/seamwise-garment.js';
import {faultOf as faultOfCallInPage} from '../../support/odd-values.js';
import {frames} from '../../support/page/waiting.js';
import {tee, useElementPage, type ElementPage} from '../../support/page/element-page.js';

const openPage = useElementPage();

declare global {
  /** Values that no argument of the element accepts, by label. */
  var odd: Readonly<Record<string, unknown>>;
  /** Returns what is wrong with the outcome of a call; empty for a value or a proper error. */
  var faultOf: (call: () => unknown) => Promise<string>;
  var faultOfCall: typeof faultOfCallInPage;
}

async function opened(): Promise<ElementPage> {
  const open = await openPage({maySay: /status of 404|Loading the image/});
  const isOwn = /\/(tee-m\.json|p4m\.json|p4m\.svg)$/;
  await open.page.route(/\/(garments|prints)\//, (route) =>
    isOwn.test(route.request().url()) ? route.fallback() : route.fulfill({status: 404}),
  );
  await open.page.evaluate(`globalThis.faultOfCall = ${String(faultOfCallInPage)}`);
  await open.page.evaluate(
    (codes) => {
      const circle: {self?: unknown} = {};
      circle.self = circle;
      globalThis.odd = {
        ...{null_: null, NaN: NaN, infinite: Infinity, negative: -1, large: 1e300, zero: 0},
        ...{big: 10n, true: true, empty: '', blank: ' ', text: 'odd', long: 'x'.repeat(1000)},
        ...{
          symbol: Symbol('odd'),
          function: () => 5,
          list: [],
          nested: [[[]]],
          symbols: [Symbol()],
        },
        ...{empty_: {}, bare: Object.create(null) as unknown, date: new Date(NaN), map: new Map()},
        ...{
          bytes: new Uint8Array(3),
          regex: /x/,
          circle,
          error: new Error('odd'),
          deep: {a: {b: []}},
        },
      };
      globalThis.faultOf = (call) => globalThis.faultOfCall(call, codes);
    },
    [...Object.keys(failureCodes), ...pageFailureCodes],
  );
  await open.put(tee);
  await open.page.locator('seamwise-garment:state(ready)').waitFor();
  return open;
}

it('rejects odd arguments of its methods, and unknown options', async () => {
  const open = await opened();
  const faults = await open.run(async (element) => {
    element.clothWidth = 140;
    const found: string[] = [];
    /** Options of `toBlob`, each with those that it belongs to. */
    const ofBlob: Readonly<Record<string, object>> = {
      ...{type: {}, width: {}, repeat: {}, dpi: {repeat: true}, paper: {type: 'application/pdf'}},
      ...Object.fromEntries(
        ['allowance', 'hem', 'ink', 'guide', 'dxfStyle', 'dxfUnit'].map((name) => [
          name,
          {type: 'application/dxf'},
        ]),
      ),
    };
    const options: Readonly<Record<string, Readonly<Record<string, object>>>> = {
      ...{solve: {signal: {}}, layPlan: {signal: {}}, toBlob: ofBlob, setDesign: {}},
    };
    for (const [method, own] of Object.entries(options)) {
      const call = Reflect.get(element, method) as (given: unknown) => Promise<unknown>;
      for (const [label, value] of Object.entries(odd)) {
        const asked = new Map([['', value]]);
        for (const [name, others] of Object.entries(own))
          asked.set(name, {...others, [name]: value});
        for (const [name, given] of asked) {
          const fault = await faultOf(() => call.call(element, given));
          if (fault) found.push(`${method} ${name} ${label}: ${fault}`);
        }
      }
    }
    for (const method of ['solve', 'layPlan', 'toBlob'] as const) {
      const unknown = {unknownOption: 1};
      const call = Reflect.get(element, method) as (given: unknown) => Promise<unknown>;
      const message = await call.call(element, unknown).then(
        () => 'accepted',
        (error: unknown) => (error as Error).message,
      );
      if (!message.includes("has no field 'unknownOption'; it has ")) found.push(message);
    }
    return found;
  });
  expect(faults).toEqual([]);
});

// 29 solves, which no single commit needs; the functions of Node are tried with the same values in each
it(
  'takes odd values of properties as the default, or reports them as an error',
  {tags: ['thorough']},
  async () => {
    const open = await opened();
    const faults = await open.run(async (element: SeamwiseGarment) => {
      const found: string[] = [];
      const own = new Map<string, unknown>();
      for (let part: object = element; part !== HTMLElement.prototype;) {
        part = Object.getPrototypeOf(part) as object;
        if (part === HTMLElement.prototype) break;
        for (const [name, property] of Object.entries(Object.getOwnPropertyDescriptors(part))) {
          if (property.set) own.set(name, Reflect.get(element, name));
        }
      }
      for (const [name, usual] of own) {
        for (const [label, value] of Object.entries(odd)) {
          const fault = await faultOf(async () => {
            Reflect.set(element, name, value);
            await element.updateComplete;
            if (['garment', 'print', 'symmetry', 'value'].includes(name)) await element.solve();
          });
          if (fault) found.push(`${name} ${label}: ${fault}`);
        }
        if (name !== 'value') Reflect.set(element, name, usual);
      }
      if (own.size < 20) found.push(`only ${[...own.keys()].join()}`);
      await element.solve();
      return found;
    });
    expect(faults).toEqual([]);
    await frames(open.page);
  },
);
