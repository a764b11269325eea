/** Panel of the print: its choice, size and direction. */
import {css, html, nothing, type TemplateResult} from 'lit';

import {noPicture, type DesignPrint} from '../../model/design/design.js';
import {section} from '../controls/section.js';
import {WorkbenchElement} from '../base/workbench-element.js';
import {controls} from '../style/controls.js';
import {icon} from '../style/icons.js';
import {toFailure} from '../../workbench/latest-solve.js';
import type {Samples} from '../../workbench/samples.js';
import type {RepeatFields} from './repeat-fields.js';
import {OpenEdgesError, printFiles, type PhotoOfFabric} from '../../print/openable-files.js';

export class PrintPanel extends WorkbenchElement {
  static override properties = {
    ...WorkbenchElement.properties,
    samples: {attribute: false},
    problem: {state: true},
  };
  declare samples: Samples | undefined;
  /** Problem with the last opened file. */
  declare protected problem: string | undefined;

  static override styles = [
    controls,
    section,
    css`
      .photo {
        justify-self: start;
      }
    `,
  ];

  /** Focuses the field for the size of the print. */
  toSize(): void {
    this.renderRoot.querySelector<RepeatFields>('sw-repeat-fields')?.focus();
  }

  protected override render(): TemplateResult | typeof nothing {
    const {workbench, samples} = this;
    if (!workbench.history.design) return nothing;
    const texts = this.texts.print;
    return html`<section aria-labelledby="title">
      <header>
        <h2 id="title">${texts.title}</h2>
        <input
          type="file"
          hidden
          accept=${printFiles}
          @change=${(event: Event) => this.#open(event.target as HTMLInputElement)}
        />
        <button class="outlined" @click=${this.#choose}>${icon.open} ${texts.open}</button>
      </header>
      <button
        class="link photo"
        aria-haspopup="dialog"
        @click=${() => {
          this.#photo();
        }}
      >
        ${texts.photo}
      </button>
      ${this.problem ? html`<p class="error" role="alert">${this.problem}</p>` : nothing}
      ${
        workbench.notices.doubtful?.beside === workbench.history.design.print
          ? html`<sw-doubtful-tile
              .workbench=${workbench}
              @another=${this.#choose}
              @photo=${({detail}: CustomEvent<PhotoOfFabric>) => {
                this.#photo(detail);
              }}
            ></sw-doubtful-tile>`
          : nothing
      }
      ${workbench.history.design.print.sample ? nothing : this.#own(workbench.history.design.print)}
      <sw-print-gallery .workbench=${workbench} .samples=${samples}></sw-print-gallery>
      <sw-repeat-fields .workbench=${workbench}></sw-repeat-fields>
      <sw-print-size .workbench=${workbench}></sw-print-size>
    </section>`;
  }

  #own(print: DesignPrint): TemplateResult {
    const {workbench} = this;
    const isPicture = !print.file && print.image !== noPicture && print.size.angleDeg === 90;
    return html`<p>${this.texts.print.own(print.title)}</p>
      <sw-tile-report .workbench=${workbench}></sw-tile-report>
      ${isPicture ? html`<sw-tile-repeat .workbench=${workbench}></sw-tile-repeat>` : nothing}`;
  }

  #photo(detail?: PhotoOfFabric): void {
    const how = {detail, bubbles: true, composed: true};
    this.dispatchEvent(new CustomEvent('sw-photo-wanted', how));
  }

  readonly #choose = (): void => {
    this.renderRoot.querySelector<HTMLInputElement>('input[type=file]')?.click();
  };

  async #open(input: HTMLInputElement): Promise<void> {
    const [file] = input.files ?? [];
    if (!file) return;
    this.problem = undefined;
    try {
      const {openPrint} = await import('../../workbench/print/open-print.js');
      await openPrint(this.workbench, file);
    } catch (error) {
      // the panel shows remedies for an image with open edges
      if (!(error instanceof OpenEdgesError)) this.problem = toFailure(error).message;
    }
    input.value = ''; // the same file can be opened again
  }
}
