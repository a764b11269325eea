/** List of the flaws of the fabric by position, to move by arrow keys or numbers, or to remove. */
import {css, html, nothing, type TemplateResult} from 'lit';

import type {Flaw} from '../../workbench/marker/lay-step.js';
import {lengthField} from '../controls/length-field.js';
import {section} from '../controls/section.js';
import {controls} from '../style/controls.js';
import {MarkerElement} from './marker-element.js';
import {flawWords} from '../../workbench/marker/marker-words.js';
import {
  boxAround,
  flawAfter,
  flawIn,
  leastFlaw,
  mostStart,
  type FlawBox,
} from '../../workbench/marker/marker-moves.js';
import type {FlawActions} from './flaw-actions.js';

export class MarkerFlaws extends MarkerElement {
  static override properties = {
    ...MarkerElement.properties,
    actions: {attribute: false},
    chosen: {attribute: false},
  };
  /** Functions that change flaws. */
  declare actions: FlawActions;
  /** Index of the flaw whose fields are open. */
  declare chosen: number | undefined;

  static override styles = [
    controls,
    section,
    css`
      section,
      ul {
        grid-template-columns: minmax(0, 1fr);
      }
      ul {
        display: grid;
        gap: var(--sw-space-2);
        margin: 0;
        padding: 0;
        list-style: none;
      }
      .row {
        display: flex;
        align-items: baseline;
        justify-content: space-between;
        gap: var(--sw-space-3);
      }
      .row .name {
        flex: 1;
        text-align: left;
        white-space: normal;
        overflow-wrap: break-word;
      }
      .row .name[aria-expanded='true'] {
        font-weight: 600;
      }
      .figures {
        display: grid;
        grid-template-columns: repeat(2, minmax(0, 1fr));
        align-items: end;
        gap: var(--sw-space-2);
        margin-block: var(--sw-space-2);
      }
      .add {
        justify-self: start;
      }
    `,
  ];

  protected override render(): TemplateResult {
    const {words} = this;
    const flaws = this.layouts.step?.flaws ?? [];
    const isPossible = this.actions.canMark;
    return html`<section class="flaws" aria-label=${words.flaws}>
      <h3>${words.flaws}</h3>
      ${
        flaws.length === 0
          ? nothing
          : html`<ul>
                ${flaws.map((flaw, k) => this.#flaw(flaw, k, isPossible))}
              </ul>
              <p id="keys" class="soft">${words.flawKeys}</p>`
      }
      <button class="outlined add" ?disabled=${!isPossible} @click=${this.#add}>
        ${words.addFlaw}
      </button>
    </section>`;
  }

  #flaw(flaw: Flaw, number: number, isPossible: boolean): TemplateResult {
    const {words, format} = this;
    const said = flawWords(flaw, number + 1, words, format);
    const isChosen = number === this.chosen;
    return html`<li>
      <div
        class="row"
        @keydown=${(event: KeyboardEvent) => {
          this.#press(event, flaw, number);
        }}
      >
        <button
          class="link name"
          aria-expanded=${isChosen}
          aria-describedby="keys"
          @click=${() => {
            this.actions.chooseFlaw(isChosen ? undefined : number);
          }}
        >
          ${said}
        </button>
        <button
          class="link"
          aria-label=${words.removeFlaw(said)}
          ?disabled=${!isPossible}
          @click=${() => {
            this.#change(number, null);
          }}
        >
          ${words.remove}
        </button>
      </div>
      ${isChosen ? this.#figures(flaw, number, said) : nothing}
    </li>`;
  }

  #figures(flaw: Flaw, number: number, said: string): TemplateResult {
    const {words} = this;
    const {bolt} = this.layouts;
    const {left, width, ...along} = boxAround(flaw);
    const widthCm = bolt?.widthCm ?? left + width;
    const field = (
      name: keyof FlawBox,
      value: number,
      [least, most]: readonly [number, number],
    ): TemplateResult =>
      this.#field(words.flawFields[name], value, [least, most], (cm) => {
        this.actions.changeFlaw(number, flawIn(flaw, {[name]: cm}, {widthCm}));
      });
    return html`<div class="figures" role="group" aria-label=${said}>
      ${field('left', left, [0, Math.max(0, widthCm - width)])}
      ${field('start', along.start, [0, mostStart])}
      ${field('width', width, [leastFlaw, Math.max(leastFlaw, widthCm - left)])}
      ${field('length', along.length, [leastFlaw, mostStart])}
    </div>`;
  }

  #field(
    label: (unit: string) => string,
    value: number,
    limits: readonly [number, number],
    enter: (cm: number) => void,
  ): TemplateResult {
    const {format, texts} = this;
    const {units} = this.workbench.preferences.chosen;
    return lengthField({label, value, limits, units, format, texts, enter});
  }

  #press(event: KeyboardEvent, flaw: Flaw, number: number): void {
    const {bolt} = this.layouts;
    if (!bolt || event.ctrlKey || event.metaKey || event.altKey) return;
    const changed = flawAfter(event, flaw, this.workbench.preferences.chosen.units, bolt);
    if (changed === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    this.#change(number, changed);
  }

  /** The focus moves to the next flaw after a removal. */
  #change(number: number, flaw: Flaw | null): void {
    this.actions.changeFlaw(number, flaw);
    if (!flaw) void this.#focusOn(number);
  }

  readonly #add = (): void => {
    this.actions.putFlaw();
    void this.#focusOn((this.layouts.step?.flaws.length ?? 0) - 1);
  };

  async #focusOn(number: number): Promise<void> {
    await this.updateComplete;
    const names = [...this.renderRoot.querySelectorAll<HTMLElement>('.name')];
    const add = this.renderRoot.querySelector<HTMLElement>('.add');
    (names[number] ?? names.at(-1) ?? add)?.focus();
  }
}
