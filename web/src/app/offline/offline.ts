/** Offline use of the page, and notices about new versions. */
import {trustedScript} from '../../model/base/trusted.js';
import {textsOf} from '../../texts/texts.js';
import type {Workbench} from '../../workbench/workbench.js';

/** Delay that keeps caching from slowing down the first drawing. [ms] */
const patience = 3000;
/** Time between two checks for a new version. [ms] */
const hour = 3_600_000;

/** Caches the page in the browser, if it is supported and allowed. */
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
    return; // the host has no service worker, or the browser forbids it; the page works without
  }
  const registration = await serviceWorker.ready;
  registration.addEventListener('updatefound', () => {
    const {installing} = registration;
    installing?.addEventListener('statechange', () => {
      if (installing.state === 'activated') void tell(workbench);
    });
  });
  setInterval(() => void registration.update().catch(() => undefined), hour); // fails offline
}

/** Requests files again that were loaded before the worker, so that it caches them. */
function again(): void {
  const loaded = performance.getEntriesByType('resource').map(({name}) => name);
  for (const url of new Set(loaded)) {
    const isSample = /\/(garments|prints)\/[^/]+$/.test(url);
    if (isSample) void fetch(url).catch(() => undefined);
  }
}

/** Reports a new version, unless the page itself is it already. */
async function tell(workbench: Workbench): Promise<void> {
  const script = document.querySelector('script[type="module"][src]')?.getAttribute('src');
  const newest = await fetch(document.baseURI, {cache: 'no-store'})
    .then((answer) => answer.text())
    .catch(() => undefined);
  if (!script || newest === undefined || newest.includes(script)) return;
  const {newVersion, reload} = textsOf(workbench.preferences.chosen.language).offline;
  const act = (): void => {
    location.reload();
  };
  workbench.notices.say({tone: 'info', text: newVersion, action: {label: reload, act}});
}
