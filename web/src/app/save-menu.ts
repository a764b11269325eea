/** Menu of files to save. */
import {css, html, type TemplateResult} from 'lit';

import {controls, placeUnder} from '../editor/style/controls.js';
import {WorkbenchElement} from '../editor/base/workbench-element.js';
import {icon} from '../editor/style/icons.js';
import type {Command} from '../commands/editor-command.js';
import type {DrapePane} from '../editor/drape/drape-pane.js';
import type {MarkerPane} from '../editor/marker/marker-pane.js';
import {labelled} from './style/page-layout.js';
import type {Projects} from './projects/projects.js';
import {saveFile} from './files.js';
import {fileNameOf} from '../model/documents/project-name.js';
import {written} from '../model/design/written-design.js';
import {writeProject} from '../model/documents/write-project.js';
import type {Workbench} from '../workbench/workbench.js';

// Saves projects, results and pictures as files.

/** Source of a saved file and of its name. */
interface Saved {
  readonly workbench: Workbench;
  readonly projects: Projects;
}

/** Returns a file's name without its ending. */
const stem = ({projects}: Saved): string => fileNameOf(projects.name);

export function saveProject(saved: Saved): void {
  const {workbench, projects} = saved;
  const {design} = workbench.history;
  if (!design) return;
  const [view, title] = [workbench.sheet.view?.get(), projects.present?.title];
  const content = writeProject(design, {
    ...(view && {view}),
    ...(title !== undefined && {title}),
  });
  saveFile(`${stem(saved)}.seamwise.json`, content);
}

/** Saves the result with its design, so that it can be opened again. */
export function saveResult(saved: Saved): void {
  const {design} = saved.workbench.history;
  const {result} = saved.workbench.solving;
  if (!design || !result) return;
  const content = JSON.stringify({...result, design: written(design)});
  saveFile(`${stem(saved)}.result.json`, content);
}

/** Saves the whole sheet as shown. */
export async function savePicture(saved: Saved): Promise<void> {
  const picture = await saved.workbench.sheet.view?.picture();
  if (picture) saveFile(`${stem(saved)}.png`, picture);
}

export class SaveMenu extends WorkbenchElement {
  static override properties = {
    ...WorkbenchElement.properties,
    projects: {attribute: false},
    view: {attribute: false},
    ofView: {state: true},
    ofRepeat: {state: true},
  };
  declare projects: Projects;
  /** View beside the pattern or in its place; undefined while there is none. */
  declare view: () => DrapePane | MarkerPane | undefined;
  declare protected ofView: readonly Command[];
  declare protected ofRepeat: readonly Command[];

  static override styles = [
    controls,
    labelled,
    css`
      :host {
        display: inline-block;
      }
      [popover] {
        width: 18rem;
      }
      .rows {
        display: grid;
        gap: var(--sw-space-3);
      }
      .rows button {
        justify-content: start;
      }
      .repeat {
        display: flex;
        flex-wrap: wrap;
        gap: var(--sw-space-2);
      }
      .repeat span {
        width: 100%;
      }
    `,
  ];

  constructor() {
    super();
    this.ofView = [];
    this.ofRepeat = [];
  }

  /** Closes the menu after a click on a button. */
  readonly #close = ({target}: Event): void => {
    if (target instanceof Element && target.closest('button'))
      this.renderRoot.querySelector<HTMLElement>('[popover]')?.hidePopover();
  };

  readonly saveOther = (ending: string, content: Blob): void => {
    saveFile(`${stem(this)}.${ending}`, content);
  };

  readonly copyLink = async (): Promise<void> => {
    const {copyLink} = await import('./links/share-link.js');
    await copyLink(this.workbench, this.projects);
  };

  async #list(): Promise<void> {
    const {repeatSaves} = await import('./saves/repeat-saves.js');
    this.ofRepeat = repeatSaves(this.workbench, this.saveOther);
    const view = this.view();
    if (!view) this.ofView = [];
    else
      this.ofView = (await import('./saves/drape-files.js')).viewSaves(
        view,
        this.workbench,
        this.saveOther,
      );
  }

  protected override render(): TemplateResult {
    const {app} = this.texts;
    const {workbench} = this;
    return html`
      <button class="outlined" popovertarget="save" ?disabled=${!workbench.history.design}>
        ${icon.save} <span class="label">${app.saveMore}</span>
      </button>
      <div
        popover
        id="save"
        @beforetoggle=${({currentTarget}: Event) => {
          void this.#list();
          placeUnder(this.renderRoot.querySelector('button'), currentTarget as HTMLElement);
        }}
      >
        <div class="rows" @click=${this.#close}>
          <button
            class="outlined"
            @click=${() => {
              saveProject(this);
            }}
          >
            ${icon.project} ${app.saveProject}
          </button>
          <button
            class="outlined"
            ?disabled=${!workbench.solving.result}
            @click=${() => {
              saveResult(this);
            }}
          >
            ${icon.result} ${app.saveResult}
          </button>
          <button
            class="outlined"
            ?disabled=${!workbench.solving.result}
            @click=${() => void savePicture(this)}
          >
            ${icon.save} ${app.savePicture}
          </button>
          ${this.ofView.map(
            ({title, run}) =>
              html`<button class="outlined" @click=${run}>${icon.save} ${title}</button>`,
          )}
          <div class="repeat" role="group" aria-labelledby="repeat">
            <span id="repeat">${this.texts.repeat.title}</span>
            ${this.ofRepeat.map(
              ({title, run}) => html`<button class="outlined" @click=${run}>${title}</button>`,
            )}
          </div>
          <button class="outlined" @click=${this.copyLink}>${icon.link} ${app.copyLink}</button>
        </div>
      </div>
    `;
  }
}
