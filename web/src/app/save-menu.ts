/** What there is to take away. */
import {css, html, type TemplateResult} from 'lit';

import {
  controls,
  WorkbenchElement,
  icon,
  lengthUnit,
  placeUnder,
  type Command,
  type NumberField,
  type WornPane,
} from '../editor/index.js';
import {labelled} from './style/page-layout.js';
import type {Projects} from './projects/projects.js';
import {saveFile} from './files.js';
import {saveCutting, savePicture, saveProject, saveResult, stem} from './save.js';

/** What most sewing patterns have. [cm] */
const usualAllowance = 1;
/** More than any hem. [cm] */
const greatestAllowance = 5;

export class SaveMenu extends WorkbenchElement {
  static override properties = {
    ...WorkbenchElement.properties,
    projects: {attribute: false},
    worn: {attribute: false},
    allowance: {state: true},
    ofWorn: {state: true},
  };
  declare projects: Projects;
  /** Undefined while it is not shown. */
  declare worn: () => WornPane | undefined;
  declare allowance: number;
  declare protected ofWorn: readonly Command[];

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
    `,
  ];

  constructor() {
    super();
    this.allowance = usualAllowance;
    this.ofWorn = [];
  }

  /** What was asked for is on its way, unless something has to be corrected first. */
  readonly #close = ({target}: Event): void => {
    const isWrong = this.renderRoot.querySelector<NumberField>('sw-number-field')?.isWrong;
    if (!isWrong && target instanceof Element && target.closest('button'))
      this.renderRoot.querySelector<HTMLElement>('[popover]')?.hidePopover();
  };

  readonly saveOther = (ending: string, content: Blob): void => {
    saveFile(`${stem(this)}.${ending}`, content);
  };

  readonly copyLink = async (): Promise<void> => {
    const {copyLink} = await import('./links/share-link.js');
    await copyLink(this.workbench, this.projects);
  };

  async #listWorn(): Promise<void> {
    const worn = this.worn();
    if (!worn) this.ofWorn = [];
    else
      this.ofWorn = (await import('./worn/saves.js')).wornSaves(
        worn,
        this.workbench,
        this.saveOther,
      );
  }

  protected override render(): TemplateResult {
    const {app, controls: controlTexts} = this.texts;
    const {workbench} = this;
    const {cm, name} = lengthUnit[workbench.preferences.units];
    return html`
      <button class="outlined" popovertarget="save" ?disabled=${!workbench.design}>
        ${icon.save} <span class="label">${app.saveMore}</span>
      </button>
      <div
        popover
        id="save"
        @beforetoggle=${({currentTarget}: Event) => {
          void this.#listWorn();
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
            ?disabled=${!workbench.result}
            @click=${() => {
              saveResult(this);
            }}
          >
            ${icon.result} ${app.saveResult}
          </button>
          <button
            class="outlined"
            ?disabled=${!workbench.result}
            @click=${() => void savePicture(this)}
          >
            ${icon.save} ${app.savePicture}
          </button>
          <sw-number-field
            .label=${app.allowance(name)}
            .value=${this.allowance / cm}
            .least=${0}
            .most=${greatestAllowance / cm}
            .step=${0.1}
            .fractions=${workbench.preferences.units === 'inch'}
            .digits=${3}
            .wrong=${controlTexts.between(this.format.length(0), this.format.length(greatestAllowance))}
            @entered=${({detail}: CustomEvent<number>) => {
              this.allowance = detail * cm;
            }}
          ></sw-number-field>
          <button
            class="outlined"
            ?disabled=${!workbench.result}
            @click=${() => {
              this.saveCutting();
            }}
          >
            ${icon.save} ${app.saveCutting}
          </button>
          ${this.ofWorn.map(
            ({title, run}) =>
              html`<button class="outlined" @click=${run}>${icon.save} ${title}</button>`,
          )}
          <button class="outlined" @click=${this.copyLink}>${icon.link} ${app.copyLink}</button>
        </div>
      </div>
    `;
  }

  /** With the allowance that is typed, and not with another one: one that is wrong is shown. */
  saveCutting(): void {
    const field = this.renderRoot.querySelector<NumberField>('sw-number-field');
    if (field?.isWrong) {
      this.renderRoot.querySelector<HTMLElement>('[popover]')?.showPopover();
      field.focus();
    } else void saveCutting(this, this.allowance);
  }
}
