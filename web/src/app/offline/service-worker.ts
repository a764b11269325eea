/**
 * Lets the page work without a network once it was there. A script of its own, of which nothing is imported: what
 * it keeps from the start is put before it when the page is built.
 */

/** The part of a service worker that is needed here; the types of pages know none. */
interface WorkerScope {
  addEventListener(type: 'install' | 'activate', listener: (event: Lasting) => void): void;
  addEventListener(type: 'fetch', listener: (event: Fetching) => void): void;
  skipWaiting(): Promise<void>;
  readonly clients: {claim(): Promise<void>};
  readonly location: Location;
  /** The files of this version of the page, relative to this script, and what tells it from others. */
  readonly seamwiseFiles: readonly string[];
  readonly seamwiseVersion: string;
}
interface Lasting {
  waitUntil(work: Promise<unknown>): void;
}
interface Fetching extends Lasting {
  readonly request: Request;
  respondWith(answer: Promise<Response>): void;
}

const scope = globalThis as unknown as WorkerScope;
const prefix = 'seamwise-page-';
const own = `${prefix}${scope.seamwiseVersion}`;
/** Garments and prints that were shown; shared by all versions. */
const samples = 'seamwise-samples';
/** Pages that are still open may load parts of the version before. */
const keptVersions = 2;

const here = new URL('./', scope.location.href);
/** Files whose name changes with their content. */
const isHashed = ({pathname}: URL): boolean => pathname.startsWith(`${here.pathname}assets/`);
const isSample = ({pathname}: URL): boolean =>
  ['garments/', 'prints/'].some((folder) => pathname.startsWith(here.pathname + folder));

scope.addEventListener('install', (event) => {
  event.waitUntil(
    (async () => {
      const cache = await caches.open(own);
      await cache.addAll(
        scope.seamwiseFiles.map((file) => {
          const url = new URL(file, here);
          return new Request(url, {cache: isHashed(url) ? 'default' : 'no-cache'});
        }),
      );
      await scope.skipWaiting();
    })(),
  );
});

scope.addEventListener('activate', (event) => {
  event.waitUntil(
    (async () => {
      const versions = (await caches.keys()).filter((name) => name.startsWith(prefix));
      const old = versions.filter((name) => name !== own).slice(0, 1 - keptVersions);
      await Promise.all(old.map((name) => caches.delete(name)));
      await scope.clients.claim();
    })(),
  );
});

scope.addEventListener('fetch', (event) => {
  const {request} = event;
  const url = new URL(request.url);
  if (request.method !== 'GET' || url.origin !== here.origin) return;
  if (isHashed(url)) event.respondWith(keptFirst(request));
  else if (isSample(url)) event.respondWith(sampleOf(request));
  else if (url.pathname.startsWith(here.pathname)) event.respondWith(newest(request));
});

/** Files are the same whoever asks for them, whatever a host says. */
const alike = {ignoreVary: true};

async function keptFirst(request: Request): Promise<Response> {
  return (await caches.match(request, alike)) ?? fetch(request);
}

/** A new version arrives where there is a network. */
async function newest(request: Request): Promise<Response> {
  try {
    return await fetch(request);
  } catch (error) {
    const kept = await (await caches.open(own)).match(request, {...alike, ignoreSearch: true});
    if (kept) return kept;
    throw error;
  }
}

async function sampleOf(request: Request): Promise<Response> {
  const cache = await caches.open(samples);
  try {
    const answer = await fetch(request);
    if (answer.ok) await cache.put(request, answer.clone());
    return answer;
  } catch (error) {
    const kept = await cache.match(request, alike);
    if (kept) return kept;
    throw error;
  }
}
