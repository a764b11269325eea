/** The element in HTML: its attributes, events and methods. */
import {order} from 'seamwise/node';
import {expect, it} from 'vitest';

import {caughtUp} from '../../support/page/waiting.js';
import {sample, tee, useElementPage} from '../../support/page/element-page.js';

const openPage = useElementPage();

it('solves and draws what its attributes name, and says so in order', async () => {
  const {put, run, asked} = await openPage();
  await put(tee.replace('print=', 'data-print='));
  const heard = await run(async (element) => {
    const heard: string[] = [element.state];
    element.print = element.dataset.print;
    for (const type of ['load', 'progress', 'solve', 'change', 'error', 'select'] as const) {
      element.addEventListener(type, ({detail, bubbles, composed}) => {
        structuredClone(detail);
        const line = `${type} ${bubbles ? 'bubbles' : 'stays'} ${composed ? 'leaves' : ''}`.trim();
        if (heard.at(-1) !== line) heard.push(line);
      });
    }
    const result = await element.solve();
    heard.push(element.state, String(element.matches(':state(ready)')));
    heard.push(String(result === element.result), String(element.error));
    return heard;
  });
  expect(heard).toEqual([
    'idle',
    'load stays',
    'progress stays',
    'solve bubbles leaves',
    'ready',
    'true',
    'true',
    'undefined',
  ]);
  expect(asked.filter((path) => path.endsWith('.json')).sort()).toEqual([
    'garments/tee-m.json',
    'prints/p4m.json',
  ]);
});

it(
  'has told all there is to be told once it is solved, however early it is asked',
  {tags: ['thorough']},
  async () => {
    const {put, page, run} = await openPage();
    await page.evaluate(() => {
      const heard: string[] = []; // precedes the element
      document.addEventListener('solve', () => heard.push('solve'));
      Object.assign(globalThis, {heard});
    });
    await put(tee.replace('alt=', 'loading="eager" alt='));
    const seen = await run(async (element) => {
      const {heard} = globalThis as unknown as {heard: readonly string[]};
      const task = (): Promise<void> =>
        new Promise((resolve) => {
          const {port1, port2} = new MessageChannel();
          port1.onmessage = () => {
            resolve();
          };
          port2.postMessage(null);
        });
      while (element.state !== 'ready') await task(); // the very next task after the answer
      await element.solve();
      return {heard, isReady: element.matches(':state(ready)')};
    });
    expect(seen).toEqual({heard: ['solve'], isReady: true});
  },
);

it('mirrors attributes as properties, and makes sense of whatever is written in them', async () => {
  const {put, run} = await openPage();
  await put('<seamwise-garment></seamwise-garment>');
  const seen = await run((element) => {
    const usual = {
      ...{garment: element.garment, print: element.print, symmetry: element.symmetry},
      ...{view: element.view, mode: element.mode, loading: element.loading, units: element.units},
      ...{maxChangeMm: element.maxChangeMm, size: element.size, alt: element.alt},
      ...{state: element.state, value: element.value},
      ...{clothWidth: element.clothWidth, selvedge: element.selvedge},
    };
    element.setAttribute('mode', 'dance');
    element.setAttribute('view', 'moon');
    element.setAttribute('loading', '');
    element.setAttribute('units', 'parsec');
    element.setAttribute('locale', '???');
    element.setAttribute('max-change-mm', 'lots');
    element.setAttribute('cloth-width', '-140');
    element.setAttribute('selvedge', 'none');
    element.setAttribute('print-sizes', '0.9, 1 x 7');
    const wrong = {
      ...{mode: element.mode, view: element.view, loading: element.loading},
      ...{units: element.units, maxChangeMm: element.maxChangeMm},
      printSizes: element.printSizes,
      ...{clothWidth: element.clothWidth, selvedge: element.selvedge},
    };
    element.mode = 'place';
    element.size = 'xl';
    element.maxChangeMm = 4;
    element.clothWidth = 140;
    element.selvedge = null;
    element.units = 'inch';
    element.workerUrl = 'w.js';
    const written = element.getAttributeNames().map((name) => [name, element.getAttribute(name)]);
    return {usual, wrong, written: Object.fromEntries(written) as Record<string, string>};
  });
  expect(seen.usual).toEqual({
    ...{garment: '', print: '', symmetry: 'auto', view: 'pattern', mode: 'preview'},
    ...{loading: 'lazy', units: 'cm', maxChangeMm: 10, size: '', alt: '', state: 'idle', value: ''},
    ...{clothWidth: null, selvedge: 1},
  });
  expect(seen.wrong).toEqual({
    ...{mode: 'preview', view: 'pattern', loading: 'lazy', units: 'cm', maxChangeMm: 10},
    ...{clothWidth: null, selvedge: 1, printSizes: [0.9, 1]},
  });
  expect(seen.written).toMatchObject({
    ...{'cloth-width': '140'},
    ...{mode: 'place', size: 'xl', 'max-change-mm': '4', units: 'inch', 'worker-url': 'w.js'},
  });
});

it(
  'understands properties that a server has written as attributes, which have no capitals',
  {tags: ['thorough']},
  async () => {
    const {put, run} = await openPage();
    const written = tee.replace('alt=', 'maxChangeMm="3" workerUrl="" wasmUrl="nowhere" alt=');
    await put(`<div class="far"></div>${written}`);
    const seen = await run(async (element) => {
      const {workerUrl, wasmUrl} = element;
      const before = [element.maxChangeMm, workerUrl, wasmUrl];
      element.wasmUrl = null;
      const attributes = ['wasm-url', 'wasmurl'].map((name) => element.hasAttribute(name));
      await element.solve();
      const solved = element.getDesign().options.maxChangeCm;
      element.setAttribute('maxchangemm', '4');
      await element.solve();
      return {before, attributes, solved: [solved, element.getDesign().options.maxChangeCm]};
    });
    expect(seen).toEqual({
      before: [3, '', 'nowhere'],
      attributes: [false, false],
      solved: [0.3, 0.4],
    });
  },
);

it(
  'tells how far it is as the solver says it, from nothing to all',
  {tags: ['thorough']},
  async () => {
    const {put, run} = await openPage();
    await put(tee.replace('tee-{size}', 'princess-dress-{size}').replace('print=', 'data-print='));
    const told = await run(async (element) => {
      const told: number[] = [];
      element.addEventListener('progress', ({detail}) => told.push(detail.fraction));
      element.addEventListener('solve', () => told.push(2));
      element.print = element.dataset.print;
      await element.solve();
      return told;
    });
    expect(told.slice(-2)).toEqual([1, 2]);
    expect(told[0]).toBe(0);
    expect(told).toEqual([...told].sort((a, b) => a - b));
    expect(told.length).toBeGreaterThan(5);
  },
);

it(
  'takes garment, print and symmetries as objects, but has then nothing to store',
  {tags: ['thorough']},
  async () => {
    const {put, page} = await openPage();
    await put('<seamwise-garment></seamwise-garment>');
    const [fit, message, value] = await page.evaluate(
      async ([garment, print]) => {
        const element = document.querySelector('seamwise-garment');
        if (!element) throw new Error('It is gone.');
        element.garment = JSON.parse(garment) as object as typeof element.garment;
        element.print = JSON.parse(print) as object as typeof element.print;
        element.symmetry = {symmetries: [{kind: 'pair', pieces: ['sleeve_left', 'sleeve_right']}]};
        const {symmetries} = await element.solve();
        const message = (() => {
          try {
            return JSON.stringify(element.getDesign());
          } catch (error) {
            return (error as Error).message;
          }
        })();
        return [symmetries.map(({kind}) => kind), message, element.value] as const;
      },
      [sample('garments/tee-m.json'), '{"group":"p4m","w1":[11,0],"w2":[0,11]}'] as const,
    );
    expect(fit).toEqual(['pair']);
    expect(message).toBe(
      'The garment was given as an object; give its URL, so that the design can be stored.',
    );
    expect(value).toBe('');
  },
);

it('stores a design that is solved again in Node, to the byte', async () => {
  const {put, run, page} = await openPage();
  await put(tee);
  const design = await run(async (element) => {
    await element.solve();
    return JSON.stringify(element.getDesign());
  });
  const read = (url: string) => {
    expect(url.startsWith(page.url())).toBe(true);
    return Promise.resolve(Buffer.from(sample(url.slice(page.url().length))));
  };
  const {reproduced} = await order(design, {read});
  expect(reproduced).toBe(true);
});

it('restores a stored design, and keeps the template of its sizes', async () => {
  const {put, run} = await openPage();
  await put(tee);
  const seen = await run(async (element) => {
    await element.solve();
    const stored = element.getDesign();
    const changed = {
      ...stored,
      garment: stored.garment,
      print: {...stored.print, size: {width: 8, height: 8, angleDeg: 90}, colourway: 'Night'},
      options: {...stored.options, maxChangeCm: 0.5},
      seed: 7,
    };
    element.size = 'l';
    await element.setDesign(JSON.stringify(changed));
    const again = element.getDesign();
    const wrong = {...changed, garment: {...changed.garment, sha256: '0'.repeat(64)}};
    const code = await element.setDesign(wrong).then(
      () => 'none',
      (error: unknown) => (error as {code: string}).code,
    );
    const noDesign = await element.setDesign('{}').catch((error: unknown) => String(error));
    return {changed, again, code, noDesign, garment: element.garment, size: element.size};
  });
  const {result, alignments, ...asked} = seen.changed;
  expect(seen.again).toMatchObject(asked);
  expect(seen.again.result).not.toBe(result);
  expect(Object.keys(seen.again.alignments)).toEqual(Object.keys(alignments));
  expect(seen.code).toBe('file-changed');
  expect(seen.noDesign).toMatch(/^FileError: design is no design/);
  expect([seen.garment, seen.size]).toEqual(['garments/tee-{size}.json', 'm']);
});

it('ends with the last of changes that follow each other', {tags: ['thorough']}, async () => {
  const {put, run} = await openPage();
  await put(tee);
  const seen = await run(async (element) => {
    const solves: unknown[] = [];
    element.addEventListener('solve', () => solves.push(element.print));
    for (const print of ['cm', 'pgg', 'p1', 'pmm']) {
      element.print = `prints/${print}.json`;
      await new Promise((resolve) => setTimeout(resolve, print === 'p1' ? 0 : 40));
    }
    const result = await element.solve();
    return {solves, group: result.print.group, print: element.print};
  });
  expect(seen).toMatchObject({group: 'pmm', print: 'prints/pmm.json'});
  expect(seen.solves.at(-1)).toBe('prints/pmm.json');
});

it(
  'settles a solve whenever it is ended, and can be asked again',
  {tags: ['thorough']},
  async () => {
    const {put, run} = await openPage();
    await put(tee.replace('tee-{size}', 'patchwork-jacket-{size}'));
    const seen = await run(async (element) => {
      const nameOf = (error: unknown): string => (error as Error).name;
      const ends: string[] = [];
      const moments = [0, 1, 5, 20, 'load', 'progress', 'progress'] as const;
      for (const [k, moment] of moments.entries()) {
        // each change is another problem: the solve before it continues
        element.maxChangeMm = 10 + k / 1000;
        const late = new AbortController();
        const abort = (): void => {
          late.abort();
        };
        if (typeof moment === 'number') setTimeout(abort, moment);
        else element.addEventListener(moment, abort, {once: true});
        ends.push(await element.solve({signal: late.signal}).then(() => 'solved', nameOf));
      }
      element.maxChangeMm = 10;
      const aborted = await element.solve({signal: AbortSignal.abort()}).catch(nameOf);
      const cancelled = element.solve().catch(nameOf);
      element.cancel();
      const asked = [aborted, await cancelled, element.state];
      return {ends, asked, again: [typeof (await element.solve()).metrics.fit, element.state]};
    });
    expect(seen.ends).toEqual(Array(7).fill('AbortError'));
    expect(seen.asked).toEqual([
      ...['AbortError', 'AbortError'],
      expect.stringMatching(/^(stale|idle)$/) as string,
    ]);
    expect(seen.again).toEqual(['number', 'ready']);
  },
);

it(
  'is loading until all have heard that its files are there, and may be told otherwise then',
  {tags: ['thorough']},
  async () => {
    const {put, run} = await openPage();
    await put(tee.replace('print=', 'data-print='));
    const seen = await run(async (element) => {
      const states: string[] = [];
      element.addEventListener('load', () => states.push(element.state), {once: true});
      element.print = element.dataset.print;
      await element.solve();
      states.push(element.state);
      element.addEventListener(
        'load',
        () => {
          element.cancel();
        },
        {once: true},
      );
      element.print = 'prints/cm.json';
      const end = await element.solve().catch((error: unknown) => (error as Error).name);
      return [...states, end, element.state];
    });
    expect(seen).toEqual(['loading', 'ready', 'AbortError', 'stale']);
  },
);

it(
  'goes on with what it does by itself when somebody who waited has gone',
  {tags: ['thorough']},
  async () => {
    const {put, page, run} = await openPage();
    await put(tee.replace('tee-{size}', 'patchwork-jacket-{size}'));
    const end = await run(async (element) => {
      const late = new AbortController();
      const solved = element.solve({signal: late.signal});
      late.abort();
      return solved.catch((error: unknown) => (error as Error).name);
    });
    expect(end).toBe('AbortError');
    await page.locator('seamwise-garment:state(ready)').waitFor();
  },
);

it(
  'ends what it does for nobody else when they have gone, and begins again when it is near',
  {tags: ['thorough']},
  async () => {
    const {put, page, run} = await openPage();
    await put(`<div class="far"></div>${tee.replace('tee-{size}', 'patchwork-jacket-{size}')}`);
    const seen = await run(async (element) => {
      const states: string[] = [element.state];
      for (const phase of ['loading', 'solving']) {
        const late = new AbortController();
        const solved = element.solve({signal: late.signal});
        while (element.state !== phase) await new Promise((resolve) => setTimeout(resolve));
        late.abort();
        const end = await solved.catch((error: unknown) => (error as Error).name);
        states.push(end as string, element.state);
      }
      for (let k = 0; k < 3; k++) await new Promise(requestAnimationFrame);
      return [...states, element.state];
    });
    expect(seen).toEqual(['idle', 'AbortError', 'idle', 'AbortError', 'stale', 'stale']);
    await run((element) => {
      element.scrollIntoView();
    });
    await page.locator('seamwise-garment:state(ready)').waitFor();
  },
);

it('gives pictures of the formats that browsers write', {tags: ['thorough']}, async () => {
  const {put, run, page} = await openPage();
  await put(tee);
  await page.locator('seamwise-garment [part=poster]').waitFor({state: 'hidden'});
  const pictures = await run(async (element) => {
    await element.solve();
    const pictures: unknown[] = [];
    for (const type of [undefined, 'image/jpeg', 'image/webp', 'text/html']) {
      const blob = await element.toBlob({width: 600, ...(type && {type})});
      const {width} = await createImageBitmap(blob);
      pictures.push([blob.type, width]);
    }
    return pictures;
  });
  expect(pictures).toEqual([
    ['image/png', 600],
    ['image/jpeg', 600],
    ['image/webp', 600],
    ['image/png', 600],
  ]);
});

it(
  'waits until it is near, and shows itself again elsewhere without asking for anything',
  {tags: ['thorough']},
  async () => {
    const {put, page, run, asked} = await openPage();
    await put(`<div class="far"></div>${tee}`);
    await caughtUp(page);
    expect(asked).toEqual([]);
    expect(await run(({state}) => state)).toBe('idle');
    await run((element) => {
      element.scrollIntoView();
    });
    await page.locator('seamwise-garment:state(ready)').waitFor();
    await page.locator('seamwise-garment [part=poster]').waitFor({state: 'hidden'});
    const before = asked.length;
    await page.clock.install();
    const taken = await page.evaluateHandle(() => {
      const element = document.querySelector('seamwise-garment');
      const result = element?.result;
      element?.remove();
      return {element, result};
    });
    await page.clock.fastForward(1500); // longer than a move to another place takes
    const same = await taken.evaluate(({element, result}) => {
      if (!element) throw new Error('It is gone.');
      document.body.append(element);
      return result !== undefined && element.result === result && element.state === 'ready';
    });
    expect(same).toBe(true);
    await page.locator('seamwise-garment [part=poster]').waitFor({state: 'hidden'});
    expect(asked.length).toBe(before);
  },
);
