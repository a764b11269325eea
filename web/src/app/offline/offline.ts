/** The page without a network, and newer versions of it. */
import {trustedScript} from '../../model/trusted.js';
import {textsOf, type Workbench} from '../../editor/index.js';

/** The first picture is not to wait for what is kept for later. [ms] */
const patience = 3000;
/** Between two looks for a new version. [ms] */
const hour = 3_600_000;

/** Has the browser keep the page, where it can and may. */
export function workOffline(workbench: Workbench): void {
  if (!('serviceWorker' in navigator)) return;
  setTimeout(() => void keep(workbench), patience);
}

async function keep(workbench: Workbench): Promise<void> {
  const {serviceWorker} = navigator;
  const isFirst = !serviceWorker.controller;
  if (isFirst) serviceWorker.addEventListener('controllerchange', again, {once: true});
  try {
    await serviceWorker.register(
      trustedScript(new URL('service-worker.js', document.baseURI).href),
    );
  } catch {
    return; // the host serves none, or the browser forbids it: the page needs none
  }
  const registration = await serviceWorker.ready;
  registration.addEventListener('updatefound', () => {
    const {installing} = registration;
    installing?.addEventListener('statechange', () => {
      if (installing.state === 'activated') void tell(workbench);
    });
  });
  setInterval(() => void registration.update().catch(() => undefined), hour); // or there is no network
}

/** What was loaded before the worker was there is asked for again, to be kept. */
function again(): void {
  const loaded = performance.getEntriesByType('resource').map(({name}) => name);
  for (const url of new Set(loaded)) {
    const isSample = /\/(garments|prints)\/[^/]+$/.test(url);
    if (isSample) void fetch(url).catch(() => undefined);
  }
}

/** A page that was loaded just now may be the new version itself. */
async function tell(workbench: Workbench): Promise<void> {
  const script = document.querySelector('script[type="module"][src]')?.getAttribute('src');
  const newest = await fetch(document.baseURI, {cache: 'no-store'})
    .then((answer) => answer.text())
    .catch(() => undefined);
  if (!script || newest === undefined || newest.includes(script)) return;
  const {newVersion, reload} = textsOf(workbench.preferences.language).offline;
  const act = (): void => {
    location.reload();
  };
  workbench.say({tone: 'info', text: newVersion, action: {label: reload, act}});
}
