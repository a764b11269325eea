/** Malicious files: they run no code, request nothing elsewhere, and leave the page working. */
import {expect, it} from 'vitest';

import {print, strips, useCarelessHost} from '../../support/page/hostile.js';
import {png} from '../../support/image/raw-png.js';
import {twoStrips} from '../../support/garments/samples.js';
import {useElementPage, type ElementPage} from '../../support/page/element-page.js';

/** No content security policy: the element must be safe without one. */
const openPage = useElementPage('');

const names = [
  '<img src="x" onerror="hurt()">',
  '<script>hurt()</script>',
  '"><svg onload=hurt()>',
  '\u202Ereversed\u2066',
  '${hurt()} {{hurt()}}',
] as const;

declare global {
  var hurt: () => void;
  var hurts: number;
}

function watch(): void {
  globalThis.hurts = 0;
  globalThis.hurt = () => {
    globalThis.hurts++;
  };
}

const hostUrl = useCarelessHost();

/** Solves one element with these files. @returns the errors until it is drawn */
async function heard(
  {page}: ElementPage,
  given: {readonly garment: unknown; readonly print: unknown},
): Promise<{codes: string[]; messages: string[]; state: string}> {
  return page.evaluate(async ({garment, print}) => {
    document.body.replaceChildren();
    const element = document.createElement('seamwise-garment');
    const [codes, messages]: [string[], string[]] = [[], []];
    element.addEventListener('error', ({detail}) => {
      codes.push(detail.code);
      messages.push(detail.message);
    });
    Object.assign(element, {garment, print, loading: 'eager'});
    document.body.append(element);
    await element.solve().catch(() => undefined);
    const poster = element.shadowRoot?.querySelector<HTMLElement>('[part=poster]');
    if (element.state === 'ready') {
      while (!poster?.hidden) await new Promise(requestAnimationFrame);
      await element.toBlob({width: 50}); // waits for the image or its error
    }
    for (let k = 0; k < 3; k++) await new Promise(requestAnimationFrame);
    return {codes, messages, state: element.state};
  }, given);
}

it('shows names as the text that they are, in every mode', async () => {
  const open = await openPage({before: watch, viewport: {width: 1200, height: 900}});
  await open.answer('garments/hostile.json', (route) => route.fulfill({json: strips(names)}));
  await open.answer('prints/hostile.json', (route) =>
    route.fulfill({
      json: {...print, title: names[0], colourways: [{name: names[1], image: 'p4m.svg'}]},
    }),
  );
  await open.put(
    '<seamwise-garment garment="garments/hostile.json" print="prints/hostile.json"></seamwise-garment>',
  );
  for (const mode of ['preview', 'place', 'edit'] as const) {
    await open.run(
      async (element, [mode, names]) => {
        element.mode = mode;
        element.alt = names[0];
        element.prints = [{url: 'prints/hostile.json', title: names[1]}, 'prints/hostile.json'];
        await element.solve();
      },
      [mode, names] as const,
    );
    const seen = (): Promise<{made: number; shown: string[]}> =>
      open.run((element, names) => {
        const look = (): {all: Element[]; texts: string[]} => {
          const all: Element[] = [];
          const walk = (root: ParentNode): void => {
            for (const one of root.querySelectorAll('*')) {
              all.push(one);
              if (one.shadowRoot) walk(one.shadowRoot);
            }
          };
          if (element.shadowRoot) walk(element.shadowRoot);
          const texts = all.flatMap((one) => [
            one.getAttribute('title') ?? '',
            ...[...one.childNodes].map((node) => (node instanceof Text ? node.data : '')),
          ]);
          return {all, texts};
        };
        const {all, texts} = look();
        return {
          made: all.filter(
            (one) =>
              one.matches('script, img[src=x], svg[onload]') ||
              one.getAttributeNames().some((name) => name.startsWith('on')),
          ).length,
          shown: names.filter((name) => texts.some((text) => text.includes(name))),
        };
      }, names);
    await open.page.locator('seamwise-garment [part=poster]').waitFor({state: 'hidden'});
    // an image shows no names
    if (mode !== 'preview')
      await expect.poll(async () => (await seen()).shown, {message: mode}).toEqual([...names]);
    expect((await seen()).made).toBe(0);
  }
  expect(await open.page.evaluate(() => globalThis.hurts)).toBe(0);
});

it(
  'runs nothing of an SVG, asks for nothing that it names, and refuses one that takes in pictures from elsewhere',
  {tags: ['thorough']},
  async () => {
    const open = await openPage({before: watch});
    const elsewhere: string[] = [];
    open.page.on('request', (request) => {
      if (request.url().includes('elsewhere')) elsewhere.push(request.url());
    });
    const svg = `<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink"
    width="1000000000" height="1000000000" viewBox="0 0 10 10" onload="parent.hurt()">
    <script>parent.hurt(); hurt()</script><script href="https://elsewhere.test/a.js"/>
    <style>@import url(https://elsewhere.test/a.css); rect {fill: url(https://elsewhere.test/b.svg#b)}</style>
    <image href="https://elsewhere.test/c.png" width="5" height="5" onerror="parent.hurt()"/>
    <use href="https://elsewhere.test/d.svg#d"/><use xlink:href="https://elsewhere.test/e.svg#e"/>
    <foreignObject width="9" height="9"><body xmlns="http://www.w3.org/1999/xhtml" onload="parent.hurt()">
      <img src="https://elsewhere.test/f.png" onerror="parent.hurt()"/>
      <iframe src="https://elsewhere.test/g.html"/></body></foreignObject>
    <animate attributeName="x" onbegin="parent.hurt()"/><rect width="5" height="5"/></svg>`;
    const without = (part: RegExp, text: string): string => text.replaceAll(part, '');
    const html = /<foreignObject.*<\/foreignObject>/gs;
    const pictures = /<image[^>]*>|<use[^>]*>|<img[^>]*>|rect {fill[^}]*}/g;
    const plain = without(pictures, without(html, svg));
    const data = (text: string): string =>
      `data:image/svg+xml;base64,${Buffer.from(text).toString('base64')}`;
    const outside = /takes in pictures from elsewhere/;
    // browsers may withhold the pixels of an SVG with HTML in it, or draw it
    const cases: readonly (readonly [text: string, code: RegExp, message: RegExp])[] = [
      [plain, /^$/, /^$/],
      [without(pictures, svg), /^(not-an-image)?$/, /^((?!pictures from elsewhere).)*$/],
      [without(html, svg), /^not-an-image$/, outside],
      [svg, /^not-an-image$/, outside],
    ];
    for (const [k, [text, code, message]] of cases.entries()) {
      const path = `prints/hostile-${k}.svg`;
      await open.answer(path, (route) => route.fulfill({contentType: 'image/svg+xml', body: text}));
      for (const image of [`${open.page.url()}${path}`, data(text)]) {
        const given = {garment: twoStrips(), print: {...print, image, colourways: undefined}};
        const seen = await heard(open, given);
        expect(seen.codes.join(), text).toMatch(code);
        expect(seen.messages.join(), text).toMatch(message);
        expect(seen.state).toBe('ready');
      }
    }
    expect(elsewhere).toEqual([]);
    expect(await open.page.evaluate(() => globalThis.hurts)).toBe(0);
  },
);

it(
  'refuses, or goes on with, whatever is too much, and stays free meanwhile',
  {tags: ['thorough']},
  async () => {
    const open = await openPage({before: watch});
    const deep = `${'['.repeat(1e6)}${']'.repeat(1e6)}`;
    const far = JSON.stringify(twoStrips()).replaceAll('10', '1e300');
    const files: Record<string, string> = {deep, far, endless: JSON.stringify(twoStrips(Infinity))};
    for (const [name, body] of Object.entries(files)) {
      await open.answer(`garments/${name}.json`, (route) =>
        route.fulfill({contentType: 'application/json', body}),
      );
    }
    const many = strips(Array.from({length: 10_000}, (_, k) => `piece ${k}`));
    await open.answer('garments/many.json', (route) => route.fulfill({json: many}));
    await open.answer('garments/html.json', (route) =>
      route.fulfill({contentType: 'text/html', body: '<!doctype html><script>hurt()</script>'}),
    );
    await open.answer('garments/typed.json', (route) =>
      route.fulfill({contentType: 'image/png', body: JSON.stringify(twoStrips())}),
    );
    const cases: readonly (readonly [string, unknown, RegExp])[] = [
      ['60 MB', `${hostUrl()}/large.json`, /^too-large$/],
      ['without end', `${hostUrl()}/endless.json`, /^too-large$/],
      ['deep', 'garments/deep.json', /^notJson$/],
      ['far', 'garments/far.json', /^\w+$/],
      ['infinite', 'garments/endless.json', /^\w+$/],
      ['an HTML page', 'garments/html.json', /^notJson$/],
      ['of another type', 'garments/typed.json', /^$/],
      ['10,000 pieces', 'garments/many.json', /^\w*$/],
    ];
    for (const [what, garment, code] of cases) {
      const seen = await heard(open, {garment, print: 'prints/p4m.json'});
      expect.soft(seen.codes.join(), what).toMatch(code);
      for (const message of seen.messages) expect(message).toMatch(/^.{10,400}\.$/s);
    }
    const objects = await open.page.evaluate(async (text) => {
      const codes: string[] = [];
      const cyclic: Record<string, unknown> = {};
      cyclic.pattern = cyclic;
      let nested: object = {};
      for (let k = 0; k < 1e5; k++) nested = {nested};
      const numberless = JSON.parse(text, (_, value: unknown) =>
        value === 10 ? NaN : value,
      ) as object;
      for (const garment of [cyclic, nested, numberless, [], {}]) {
        const element = document.createElement('seamwise-garment');
        Object.assign(element, {garment, print: 'prints/p4m.json'});
        const code = await element.solve().then(
          () => 'solved',
          (error: unknown) => (error as {code: string}).code,
        );
        codes.push(code);
      }
      return codes;
    }, JSON.stringify(twoStrips()));
    expect(objects).toEqual(['notJson', 'notJson', 'number', 'notAGarment', 'notAGarment']);
  },
);

const bytes = (text: string): Buffer => Buffer.from(text.replaceAll(' ', ''), 'hex');

it(
  'refuses a picture of too many pixels by its first bytes, and scales what it can',
  {tags: ['thorough']},
  async () => {
    const open = await openPage({before: watch});
    const box = (type: string, ...data: Buffer[]): Buffer => {
      const head = Buffer.alloc(8);
      const all = Buffer.concat(data);
      head.writeUInt32BE(8 + all.length, 0);
      head.write(type, 4, 'latin1');
      return Buffer.concat([head, all]);
    };
    const pictured = (image: string) =>
      heard(open, {garment: twoStrips(), print: {...print, image, colourways: undefined}});
    await open.answer('prints/largest.png', (route) =>
      route.fulfill({contentType: 'image/png', body: png(4096, 4096)}),
    );
    // the largest possible texture
    await pictured(`${open.page.url()}prints/largest.png`);
    const cases: readonly (readonly [string, string, string, Buffer])[] = [
      ['PNG head', 'too-large', 'image/png', png(20_000, 20_000, false)],
      ['PNG', 'too-large', 'image/png', png(20_000, 20_000)],
      [
        'JPEG',
        'too-large',
        'image/jpeg',
        bytes('ffd8 ffe00004 0000 ffff ffc0 0011 08 4e20 4e20 03 000000000000'),
      ],
      [
        'WebP',
        'too-large',
        'image/webp',
        bytes('52494646 00100000 57454250 56503858 0a000000 00000000 1f4e00 1f4e00 00000000'),
      ],
      [
        'GIF',
        'too-large',
        'image/gif',
        bytes('474946383961 0100 0100 00 00 00 21f904 01000000 00 2c 0000 0000 204e 204e 00 02'),
      ],
      [
        'AVIF',
        'too-large',
        'image/avif',
        Buffer.concat([
          box('ftyp', Buffer.from('avif\0\0\0\0mif1', 'latin1')),
          box(
            'meta',
            Buffer.alloc(4),
            box('iprp', box('ipco', box('ispe', bytes('00000000 00004e20 00004e20')))),
          ),
        ]),
      ],
      [
        'BMP',
        'not-an-image',
        'image/bmp',
        bytes('424d 36000000 00000000 36000000 28000000 204e0000 204e0000 0100 1800'),
      ],
      ['cut short', 'not-an-image', 'image/png', png(100, 100).subarray(0, 20)],
      ['a lie', 'not-an-image', 'image/png', png(100, 100, false).subarray(0, 60)],
      ['HTML', 'not-an-image', 'text/html', Buffer.from('<script>hurt()</script>')],
      ['a PNG as an SVG', 'not-an-image', 'image/svg+xml', png(100, 100)],
      [
        'an SVG of another type',
        'not-an-image',
        'image/png',
        Buffer.from('<svg xmlns="http://www.w3.org/2000/svg" onload="hurt()"/>'),
      ],
      ['a PNG of another type', '', 'text/html', png(100, 100)],
      ['60 megapixels', '', 'image/png', png(20_000, 3000)],
    ];
    for (const [what, code, contentType, body] of cases) {
      const path = `prints/${encodeURIComponent(what)}.bin`;
      await open.answer(path, (route) => route.fulfill({contentType, body}));
      const urls = [`${open.page.url()}${path}`];
      if (body.length < 1000 && !contentType.includes('svg')) {
        urls.push(`data:${contentType};base64,${body.toString('base64')}`);
      }
      for (const image of urls) {
        const seen = await pictured(image);
        expect.soft([seen.codes.join(), seen.state], what).toEqual([code, 'ready']);
      }
    }
    expect(await open.page.evaluate(() => globalThis.hurts)).toBe(0);
  },
);
