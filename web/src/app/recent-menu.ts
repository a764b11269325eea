/** What was worked on lately, to go on with. */
import {css, html, type TemplateResult} from 'lit';

import {controls, DeskElement, icon} from '../element/index.js';
import type {Keeper} from './keeper.js';
import type {RecentProject} from './storage/autosave.js';

export class RecentMenu extends DeskElement {
  static override properties = {
    ...DeskElement.properties,
    keeper: {attribute: false},
    projects: {state: true},
  };
  declare keeper: Keeper;
  declare projects: readonly RecentProject[];

  static override styles = [
    controls,
    css`
      button.icon {
        width: 2rem;
        padding: 0;
      }
      [popover] {
        position: fixed;
        inset: 3.5rem auto auto var(--sw-space-4);
        width: 20rem;
        max-height: 70dvh;
      }
      ul {
        margin: var(--sw-space-2) 0 0;
        padding: 0;
        list-style: none;
      }
      li button {
        justify-content: space-between;
        width: 100%;
        padding: 0 var(--sw-space-2);
      }
    `,
  ];

  constructor() {
    super();
    this.projects = [];
  }

  protected override render(): TemplateResult {
    const {app} = this.texts;
    return html`
      <button class="icon" aria-label=${app.recent} title=${app.recent} popovertarget="recent">
        ${icon.recent}
      </button>
      <div
        popover
        id="recent"
        role="region"
        aria-label=${app.recent}
        @beforetoggle=${() => void this.#list()}
      >
        <h2>${app.recent}</h2>
        ${
          this.projects.length === 0
            ? html`<p class="soft">${app.noRecent}</p>`
            : html`<ul>
                ${this.projects.map(
                  ({id, name, changed}) =>
                    html`<li>
                      <button @click=${() => void this.#take(id)}>
                        <span>${name}</span>
                        <span class="soft">${this.format.moment(changed)}</span>
                      </button>
                    </li>`,
                )}
              </ul>`
        }
      </div>
    `;
  }

  async #list(): Promise<void> {
    this.projects = await this.keeper.recent();
  }

  async #take(id: string): Promise<void> {
    const history = await this.keeper.take(id);
    this.renderRoot.querySelector<HTMLElement>('[popover]')?.hidePopover();
    if (history) this.desk.begin(history);
  }
}
