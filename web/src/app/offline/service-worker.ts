/**
 * Lets the page work offline after its first visit. A separate script without imports: the build
 * prepends the list of files to cache.
 */

/** The used part of a service worker's scope, which the page's types lack. */
interface WorkerScope {
  addEventListener(type: 'install' | 'activate', listener: (event: Lasting) => void): void;
  addEventListener(type: 'fetch', listener: (event: Fetching) => void): void;
  skipWaiting(): Promise<void>;
  readonly clients: {claim(): Promise<void>};
  readonly location: Location;
  /** Files of this version of the page, relative to this script, and the version's identifier. */
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
/** Cache of opened garments and prints, shared by all versions. */
const samples = 'seamwise-samples';
/** Number of cached versions: open pages may load parts of the previous one. */
const keptVersions = 2;

const here = new URL('./', scope.location.href);
/** Returns whether a file's name changes with its content. */
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

/** Ignores `Vary` headers: the files do not depend on the request. */
const alike = {ignoreVary: true};

async function keptFirst(request: Request): Promise<Response> {
  return (await caches.match(request, alike)) ?? fetch(request);
}

/** Prefers the network, so that new versions arrive. */
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
