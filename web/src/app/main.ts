/** Puts the page together. */
import {
  defineEditor,
  leaseSolver,
  loadSamples,
  textsOf,
  toFailure,
  Workbench,
} from '../element/index.js';
import type {Design} from '../model/design.js';
import {askedFor, firstDesign} from './first-design.js';
import {Keeper} from './keeper.js';
import {SeamwisePage} from './page.js';
import {RecentMenu} from './recent-menu.js';
import {SaveMenu} from './save-menu.js';
import {keepPreferences, storedPreferences} from './storage/preferences.js';

const samples = loadSamples();
const lease = leaseSolver({
  onBlocked: ({message}) => {
    desk.say({tone: 'info', text: message});
  },
});
lease.warm(); // while the first files are on their way
const desk: Workbench = new Workbench(lease, storedPreferences());
keepPreferences(desk);
const keeper = new Keeper(desk, (trouble) => {
  desk.say({tone: 'error', text: textsOf(desk.preferences.language).storage[trouble]});
});

defineEditor();
customElements.define('sw-recent-menu', RecentMenu);
customElements.define('sw-save-menu', SaveMenu);
customElements.define('seamwise-page', SeamwisePage);
const page = new SeamwisePage();
page.desk = desk;
page.keeper = keeper;
document.body.append(page);

const sayFailure = (error: unknown): void => {
  desk.say({tone: 'error', text: toFailure(error).message});
};

async function begin(address: URL): Promise<void> {
  const resumed = address.hash === '' && address.search === '' ? await keeper.resumed() : undefined;
  if (resumed) {
    desk.begin(resumed);
    return;
  }
  const design = await firstDesign(samples, address);
  const [asked] = await Promise.allSettled([soundlyAsked(address, design)]);
  const present = (asked.status === 'fulfilled' ? asked.value : undefined) ?? design;
  desk.replace(present);
  // said last, since a beginning takes back what was said before
  if (asked.status === 'rejected') sayFailure(asked.reason);
  // once something is changed, the tab shows what is made of it
  const end = desk.subscribe(() => {
    if (!desk.canUndo) return;
    end();
    history.replaceState(null, '', address.pathname);
  });
}

/** What the address asks for, if it can be read. */
async function soundlyAsked(address: URL, before: Design): Promise<Design | undefined> {
  const asked = await askedFor(address, before);
  if (asked) await desk.meshed(asked);
  return asked;
}

try {
  void samples.then((known) => {
    page.samples = known;
  }, sayFailure);
  await begin(new URL(location.href));
} catch (error) {
  desk.beginEmpty();
  sayFailure(error);
}
keeper.follow(new AbortController().signal);
// a link that is followed from here to here does not load the page by itself
addEventListener('hashchange', () => {
  location.reload();
});
