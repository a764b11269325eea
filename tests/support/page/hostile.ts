/** Malicious files. */
import {createServer, type Server} from 'node:http';
import type {AddressInfo} from 'node:net';

import {afterAll, beforeAll} from 'vitest';

import {sample} from './element-page.js';
import {twoStrips} from '../garments/samples.js';

/** A harmless print. */
export const print = JSON.parse(sample('prints/p4m.json')) as object;

/** Rectangles with these names, each sewn to the next. */
export function strips(called: readonly string[]): object {
  const {pattern, properties} = twoStrips();
  const {left} = pattern.panels;
  return {
    pattern: {
      panels: Object.fromEntries(called.map((name) => [name, left])),
      stitches: called.slice(1).map((panel, k) => [
        {panel: called[k], edge: 1},
        {panel, edge: 3},
      ]),
    },
    properties,
  };
}

/**
 * Serves files that are too large or endless. @returns the address of the host, without a slash at
 * its end
 */
export function useCarelessHost(): () => string {
  let host: Server | undefined;
  let url = '';
  beforeAll(async () => {
    host = createServer((request, response) => {
      const isEndless = request.url === '/endless.json';
      response.writeHead(200, {
        'Access-Control-Allow-Origin': '*',
        'Content-Type': 'application/json',
        ...(!isEndless && {'Content-Length': 60e6}),
      });
      const part = Buffer.alloc(1e6, ' ');
      const send = (): void => {
        while (!response.destroyed && response.write(part));
      };
      response.on('drain', send);
      send();
    });
    await new Promise<void>((resolve) => host?.listen(0, resolve));
    url = `http://localhost:${(host.address() as AddressInfo).port}`;
  });
  afterAll(() => {
    host?.closeAllConnections();
    host?.close();
  });
  return () => url;
}
