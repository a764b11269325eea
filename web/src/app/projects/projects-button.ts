/** Button that shows the list of projects; the list is loaded on first use. */
import {css, html, type TemplateResult} from 'lit';

import {register} from '../../editor/base/register.js';
import {WorkbenchElement} from '../../editor/base/workbench-element.js';
import {controls} from '../../editor/style/controls.js';
import {icon} from '../../editor/style/icons.js';
import type {Design} from '../../model/design/design.js';
import {labelled, unseen} from '../style/page-layout.js';
import type {ProjectList} from './project-list.js';
import type {Projects} from './projects.js';

export class ProjectsButton extends WorkbenchElement {
  static override properties = {
    ...WorkbenchElement.properties,
    projects: {attribute: false},
    blank: {attribute: false},
  };
  static override styles = [
    controls,
    labelled,
    css`
      @container (width < 72rem) {
        .outlined {
          border-color: transparent;
          background: none;
        }
        .label {
          ${unseen}
        }
      }
    `,
  ];
  declare projects: Projects;
  /** Returns the design shown after the last project is deleted. */
  declare blank: () => Promise<Design>;

  async open(): Promise<void> {
    const {ProjectList} = await import('./project-list.js');
    register('sw-project-list', ProjectList);
    const list = this.renderRoot.querySelector<ProjectList>('sw-project-list');
    await list?.updateComplete; // it has its properties from then on
    await list?.open();
  }

  protected override render(): TemplateResult {
    const {title} = this.texts.projects;
    return html`
      <button
        class="outlined"
        title=${title}
        aria-haspopup="dialog"
        @click=${() => void this.open()}
      >
        ${icon.projects} <span class="label">${title}</span>
      </button>
      <sw-project-list
        .workbench=${this.workbench}
        .projects=${this.projects}
        .blank=${this.blank}
      ></sw-project-list>
    `;
  }
}
