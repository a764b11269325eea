/** Assembles the page. */
import {defineEditor} from '../editor/editor.js';
import {leaseSolver} from '../solver/pool.js';
import {loadSamples} from '../workbench/samples.js';
import {loadTexts, textsOf, type Texts} from '../texts/texts.js';
import {spokenFailure} from '../workbench/spoken-failure.js';
import {toFailure} from '../workbench/latest-solve.js';
import {offerProjects} from '../workbench/marker/project-source.js';
import {Workbench} from '../workbench/workbench.js';
import type {Design} from '../model/design/design.js';
import {askedFor, firstDesign, welcomeDesign} from './first-design.js';
import {isFirstVisit} from './introduction/first-visit.js';
import {Welcome} from './introduction/welcome.js';
import {SeamwisePage} from './page.js';
import {illustrate} from './projects/illustrate.js';
import {ProjectsButton} from './projects/projects-button.js';
import {Projects} from './projects/projects.js';
import {SaveMenu} from './save-menu.js';
import {keepPreferences, storedPreferences} from './storage/preferences.js';

const samples = loadSamples();
const preferences = storedPreferences();
const words = (): Texts => textsOf(workbench.preferences.chosen.language);
const lease = leaseSolver({
  onBlocked: (failure) => {
    workbench.notices.say({tone: 'info', text: spokenFailure(failure, workbench, words())});
  },
});
lease.warm(); // the solver starts while the first files load
const workbench: Workbench = new Workbench(lease, preferences);
keepPreferences(workbench);
const projects = new Projects(workbench, (trouble) => {
  workbench.notices.say({tone: 'error', text: words().storage[trouble]});
});
offerProjects(workbench, {
  list: async () => (await projects.entries()).filter(({open, isDeleted}) => !open && !isDeleted),
  designOf: (id) => projects.designOf(id),
});

defineEditor();
customElements.define('sw-projects-button', ProjectsButton);
customElements.define('sw-save-menu', SaveMenu);
customElements.define('sw-welcome', Welcome);
customElements.define('seamwise-page', SeamwisePage);
const page = new SeamwisePage();
page.workbench = workbench;
page.projects = projects;
page.blank = () => firstDesign(samples);

const sayFailure = (error: unknown): void => {
  workbench.notices.say({tone: 'error', text: toFailure(error).message});
};

const isBare = ({hash, search}: URL): boolean => hash === '' && search === '';

async function begin(address: URL): Promise<void> {
  await projects.rescue();
  if (isBare(address) && (await projects.resume())) {
    page.isFirst = false;
    return;
  }
  if (await followed(address)) return;
  if (address.search === '' && isFirstVisit()) {
    page.isFirst = true;
    const {beginOpening} = await import('./introduction/opening.js');
    await beginOpening(workbench, welcomeDesign(samples), (design) => {
      projects.beginWith(design, {origin: 'given'});
    });
    return;
  }
  const design = await firstDesign(samples);
  const [asked] = await Promise.allSettled([soundlyAsked(address, design)]);
  const present = (asked.status === 'fulfilled' ? asked.value : undefined) ?? design;
  projects.beginWith(present, {origin: 'given'});
  // shown last, since a new design removes previous notices
  if (asked.status === 'rejected') sayFailure(asked.reason);
  forgetAddress();
}

/**
 * Removes the URL's parameters after the first change, so that a reload restores the changed
 * project.
 */
function forgetAddress(): void {
  const {beginnings} = workbench.history;
  const end = workbench.subscribe(['history'], () => {
    if (!workbench.history.canUndo && workbench.history.beginnings === beginnings) return;
    end();
    history.replaceState(null, '', location.pathname);
  });
}

/** Opens the link in the URL; a damaged link leaves the page as it was. */
async function followed(address: URL): Promise<boolean> {
  try {
    if (address.hash === '') return false;
    const {openLink} = await import('./links/open-link.js');
    if (!(await openLink(address.hash, workbench, projects, samples))) return false;
    await projects.present?.flush();
    // a reload opens the link again without storage
    if (projects.present?.unwritten) forgetAddress();
    else history.replaceState(null, '', address.pathname);
    return true;
  } catch (error) {
    history.replaceState(null, '', address.pathname);
    if (!workbench.history.design && !(await projects.resume())) {
      projects.beginWith(await firstDesign(samples), {origin: 'given'});
    }
    sayFailure(error);
    return true;
  }
}

/** Codes of failures that a garment does not cause. */
const unrelated: ReadonlySet<unknown> = new Set(['no-wasm', 'network', 'timeout']);

/**
 * Returns the design in the URL. A solver that cannot be loaded leaves it as it is, since the solve
 * reports the same failure.
 *
 * @throws {Error} when a file in the URL cannot be read
 */
async function soundlyAsked(address: URL, before: Design): Promise<Design | undefined> {
  const asked = await askedFor(address, before, workbench.solver);
  if (!asked) return undefined;
  try {
    await workbench.solving.meshed(asked);
  } catch (error) {
    if (!unrelated.has(toFailure(error).code)) throw error;
  }
  return asked;
}

/** Calls back once no answer is awaited for the first time. */
function afterFirstAnswer(act: () => Promise<void>): void {
  const isAwaited = () => ['opening', 'solving'].includes(workbench.solving.state.kind);
  const end = workbench.subscribe(['solving'], follow);
  function follow(): void {
    if (isAwaited()) return;
    end();
    void act().catch(() => undefined); // the page works without
  }
  follow();
}

/** Shows nothing before the texts are loaded. */
async function open(): Promise<void> {
  await loadTexts(preferences.language);
  const address = new URL(location.href);
  page.isFirst = isBare(address) && isFirstVisit(); // from the first picture on, so that nothing moves
  document.body.append(page);
  try {
    void samples.then((known) => {
      page.samples = known;
    }, sayFailure);
    await begin(address);
  } catch (error) {
    workbench.solving.beEmpty();
    sayFailure(error);
  }
  projects.keep(new AbortController().signal);
  illustrate(workbench, projects);
  afterFirstAnswer(async () => {
    const {workOffline} = await import('./offline/offline.js');
    workOffline(workbench);
  });
  // a link to this page does not reload it
  addEventListener('hashchange', () => {
    if (location.hash !== '') void followed(new URL(location.href));
  });
}

// not awaited: lazily loaded modules import from this one, and would wait for its end
void open();
