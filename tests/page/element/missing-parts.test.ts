/**
 * Each file that the standalone build loads on demand, missing for a while: the element reports an
 * error with a code, keeps its state, and works once the file is there.
 */
import {cp, mkdtemp, readdir, rm, writeFile} from 'node:fs/promises';
import {tmpdir} from 'node:os';
import {basename, join} from 'node:path';
import {fileURLToPath} from 'node:url';

import type {Page, Route} from 'playwright-core';
import {afterAll, beforeAll, expect, it, vi} from 'vitest';

import {failureCodes, pageFailureCodes} from '@/model/base/failure.js';
import {serveFiles} from '../../support/page/browser.js';
import {useChromium} from '../../support/package/examples.js';

vi.setConfig({testTimeout: 400_000});
const project = fileURLToPath(new URL('../../..', import.meta.url));
const open = useChromium();
const codes: readonly string[] = [...Object.keys(failureCodes), ...pageFailureCodes];

let folder: string;
let served: Awaited<ReturnType<typeof serveFiles>>;
/** Files of the build that pages may request. */
let built: readonly string[];

beforeAll(async () => {
  folder = await mkdtemp(join(tmpdir(), 'seamwise-parts-'));
  for (const [from = '', to = ''] of [
    ['dist/standalone', 'seamwise'],
    ['public/garments/tee-m.json', 'garments/tee-m.json'],
    ['public/icon.svg', 'icon.svg'],
    ...['p4m.json', 'p4m.svg'].map((file) => [`public/prints/${file}`, `prints/${file}`]),
  ]) {
    await cp(join(project, from), join(folder, to), {recursive: true});
  }
  await writeFile(
    join(folder, 'index.html'),
    `<!doctype html><link rel="icon" href="icon.svg" /><script type="module" src="seamwise/seamwise.js"></script>
     <seamwise-garment loading="eager" garment="garments/tee-m.json" print="prints/p4m.json"></seamwise-garment>`,
  );
  built = (await readdir(join(folder, 'seamwise'))).filter((name) => /\.(js|wasm)$/.test(name));
  served = await serveFiles(folder, "default-src 'self' 'wasm-unsafe-eval'; img-src 'self' data:");
});
afterAll(async () => {
  await served.close();
  await rm(folder, {recursive: true});
});

/** Ways in which a host fails to send a file. */
const ways: readonly ((route: Route) => Promise<void>)[] = [
  (route) => route.fulfill({status: 404, body: 'none'}),
  (route) => route.fulfill({status: 200, contentType: 'text/html', body: '<!doctype html>'}),
  (route) => route.abort(),
];

interface Visit {
  readonly page: Page;
  /** Requested files of the build, each once. */
  readonly asked: Set<string>;
  /** The file that is missing, and how. */
  missing: {readonly name: string; readonly way: number} | undefined;
}

async function visit(missing?: Visit['missing']): Promise<Visit> {
  const page = await open('about:blank', {maySay: /./});
  const visited: Visit = {page, asked: new Set(), missing};
  await page.route(/\/seamwise\//, async (route) => {
    const name = basename(new URL(route.request().url()).pathname);
    visited.asked.add(name);
    const {missing: lost} = visited;
    if (lost?.name === name) await ways[lost.way % ways.length]?.(route);
    else await route.fallback();
  });
  await page.goto(served.url);
  await page.waitForFunction(() => customElements.get('seamwise-garment'));
  return visited;
}

/** Calls that load parts on demand. A failure is an error, or an `error` event. */
const actions = {
  'a cutting sheet as PDF': ['toBlob', {type: 'application/pdf'}],
  'a cutting sheet as DXF': ['toBlob', {type: 'application/dxf'}],
  'a cutting sheet as HP-GL': ['toBlob', {type: 'application/vnd.hp-hpgl'}],
  'a cutting sheet as SVG': ['toBlob', {type: 'image/svg+xml'}],
  'the repeat of the print': ['toBlob', {repeat: true, dpi: 30}],
  'a fabric layout': ['layPlan', {}],
} as const;

/** Runs an action. @returns the code of its error, 'none' for an error without, empty for success */
const outcome = (page: Page, [method, options]: readonly [string, object]): Promise<string> =>
  page.locator('seamwise-garment').evaluate(
    async (element, [name, given]) => {
      element.setAttribute('cloth-width', '140');
      const call = Reflect.get(element, name as string) as (given: unknown) => Promise<unknown>;
      return call.call(element, given).then(
        () => '',
        (error: unknown) => (error as {code?: string}).code ?? `none: ${String(error)}`,
      );
    },
    [method, options],
  );

it('works again once a part of a file or layout is there', {tags: ['thorough']}, async () => {
  const healthy = await visit();
  await healthy.page.locator('seamwise-garment:state(ready)').waitFor();
  const parts = new Map<string, readonly string[]>();
  for (const [what, action] of Object.entries(actions)) {
    const before = new Set(healthy.asked);
    expect(await outcome(healthy.page, action), what).toBe('');
    parts.set(
      what,
      [...healthy.asked].filter((name) => !before.has(name)),
    );
  }
  expect([...parts.values()].flat().length).toBeGreaterThan(10);
  await healthy.page.context().close();

  const walk = await visit();
  await walk.page.locator('seamwise-garment:state(ready)').waitFor();
  let way = 0;
  for (const [what, action] of Object.entries(actions)) {
    for (const name of parts.get(what) ?? []) {
      walk.missing = {name, way: way++};
      const code = await outcome(walk.page, action);
      expect(['', ...codes], `${what} without ${name}`).toContain(code);
    }
    walk.missing = undefined;
    expect(await outcome(walk.page, action), what).toBe('');
  }
});

it(
  'reports a missing part of the first result, and solves again',
  {tags: ['thorough']},
  async () => {
    const healthy = await visit();
    await healthy.page.locator('seamwise-garment:state(ready)').waitFor();
    const first = [...healthy.asked].filter((name) => !/^(seamwise|opening-.*)\.js$/.test(name));
    expect(first.every((name) => built.includes(name))).toBe(true);
    await healthy.page.context().close();
    for (const [way, name] of first.entries()) {
      const broken = await visit({name, way});
      const solved = await outcome(broken.page, ['solve', {}]);
      expect(['', ...codes], name).toContain(solved);
      const state = await broken.page
        .locator('seamwise-garment')
        .evaluate((element) => (element as unknown as {state: string}).state);
      expect(state, name).toBe(solved === '' ? 'ready' : 'error');
      broken.missing = undefined;
      expect(await outcome(broken.page, ['solve', {}]), name).toBe('');
      await broken.page.context().close();
    }
  },
);
