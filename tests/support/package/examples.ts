/** The examples as readers run them: copied into a new folder with the packed package installed. */
import {spawn, type ChildProcess} from 'node:child_process';
import {cp, mkdtemp, rm} from 'node:fs/promises';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {fileURLToPath} from 'node:url';

import type {Browser, BrowserContextOptions, Page} from 'playwright-core';
import {afterAll, afterEach, beforeAll, expect, vi} from 'vitest';

import {openBrowser} from '../page/browser.js';
import {packed, type Packed} from './packed.js';

const at = (path: string): string => fileURLToPath(new URL(`../../../${path}`, import.meta.url));
/** Garments and prints, which are not part of the examples. */
export const samples = at('public');

interface Examples {
  /** Copies an example, with further packages of the project that it needs. @returns its folder */
  readonly copy: (name: string, others?: readonly string[]) => Promise<string>;
  /** Starts a server in Node. @returns its address, once the server has printed it */
  readonly serve: (folder: string, words: readonly string[]) => Promise<string>;
}

export function useExamples(): Examples {
  vi.setConfig({testTimeout: 180_000, hookTimeout: 300_000}); // a busy machine is slow
  let all: Packed | undefined;
  const folders: string[] = [];
  const servers: ChildProcess[] = [];

  beforeAll(async () => {
    all = await packed();
  });
  afterAll(async () => {
    for (const server of servers) server.kill();
    await Promise.all(folders.map((folder) => rm(folder, {recursive: true, force: true})));
    await all?.remove();
  });

  return {
    copy: async (name, others = []) => {
      const folder = await mkdtemp(join(tmpdir(), `seamwise-${name}-`));
      folders.push(folder);
      await cp(at(`web/examples/${name}`), folder, {recursive: true});
      await all?.installIn(folder, others);
      return folder;
    },
    serve: (folder, words) => {
      const server = spawn(process.execPath, words, {
        cwd: folder,
        stdio: ['ignore', 'pipe', 'inherit'],
        env: {...process.env, NODE_ENV: undefined, NO_COLOR: '1'},
      });
      servers.push(server);
      return new Promise((resolve, reject) => {
        let printed = '';
        server.stdout.on('data', (text: Buffer) => {
          printed += text.toString();
          const address = /http:\/\/localhost:\d+\//.exec(printed)?.[0];
          if (address !== undefined) resolve(address);
        });
        server.on('exit', () => {
          reject(new Error(`The server has ended: ${printed}`));
        });
      });
    },
  };
}

interface ChromiumOptions extends BrowserContextOptions {
  /** Console messages to accept, where a test breaks something on purpose. */
  readonly maySay?: RegExp;
}

/** Software rendering draws a motion's frames slowly. */
const usual = {viewport: {width: 1440, height: 900}, reducedMotion: 'reduce'} as const;

/**
 * Opens pages in Chromium. Any message on the console fails the test, and so does a request to
 * another host.
 * @param maySay  harmless messages of other programs
 */
export function useChromium(
  maySay?: RegExp,
): (url: string, options?: ChromiumOptions) => Promise<Page> {
  let browser: Browser;
  const said: string[] = [];

  beforeAll(async () => {
    browser = await openBrowser();
  });
  afterEach(async () => {
    await Promise.all(browser.contexts().map((context) => context.close()));
    expect(said.splice(0)).toEqual([]);
  });
  afterAll(() => browser.close());

  return async (url, {maySay: here, ...context} = {}) => {
    const page = await (await browser.newContext({...usual, ...context})).newPage();
    const hear = (text: string): void => {
      // software rendering is slow to return pixels, and logs it
      if (!text.includes('GPU stall') && !maySay?.test(text) && !here?.test(text)) said.push(text);
    };
    page.on('console', (message) => {
      hear(message.text());
    });
    page.on('pageerror', ({message}) => {
      hear(message);
    });
    page.on('request', (request) => {
      if (new URL(request.url()).host !== new URL(url).host) hear(`asked ${request.url()}`);
    });
    await page.goto(url);
    return page;
  };
}

/** Waits for the answer to the element's current problem. */
export const solved = async (page: Page): Promise<void> => {
  await page.locator('seamwise-garment:state(ready)').first().waitFor({timeout: 60_000});
};
