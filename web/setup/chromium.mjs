import {existsSync, readdirSync} from 'node:fs';
import {homedir} from 'node:os';
import {delimiter, join} from 'node:path';

/** The headless shell comes first, as it needs less processor time. */
const commands = [
  'chromium-headless-shell',
  'chromium',
  'chromium-browser',
  'google-chrome',
  'google-chrome-stable',
];
const applications = [
  'Chromium.app/Contents/MacOS/Chromium',
  'Google Chrome.app/Contents/MacOS/Google Chrome',
];

/** The Chromium or Chrome for tests: that of CHROME_PATH, else the first installed; or null. */
export function chromiumPath() {
  if (process.env.CHROME_PATH) return process.env.CHROME_PATH;
  const folders = (process.env.PATH ?? '').split(delimiter);
  const places = [
    ...commands.flatMap((command) => folders.map((folder) => join(folder, command))),
    ...applications.map((application) => join('/Applications', application)),
    ...playwrightPlaces(),
  ];
  return places.find((place) => existsSync(place)) ?? null;
}

/** Paths used by `npx playwright install chromium`, newest first. */
function playwrightPlaces() {
  const caches = [
    process.env.PLAYWRIGHT_BROWSERS_PATH,
    join(homedir(), '.cache/ms-playwright'),
    join(homedir(), 'Library/Caches/ms-playwright'),
  ];
  return caches.filter((cache) => cache && existsSync(cache)).flatMap(inCache);
}

function inCache(cache) {
  const versions = readdirSync(cache).filter((name) => /^chromium-\d+$/.test(name));
  versions.sort((a, b) => Number(b.split('-')[1]) - Number(a.split('-')[1]));
  return versions.flatMap((version) =>
    readdirSync(join(cache, version)).flatMap((system) =>
      ['chrome', ...applications].map((program) => join(cache, version, system, program)),
    ),
  );
}
