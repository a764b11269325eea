/** Kind and size of the selected fold, or kind of the next one. */
import {css, html, nothing, svg, type TemplateResult} from 'lit';

import {foldKinds, type DraftedFold, type FoldKind} from '../../model/garment/garment-document.js';
import {hidesFabric} from '../../model/garment/folds.js';
import {WorkbenchElement} from '../base/workbench-element.js';
import {lengthField} from '../controls/length-field.js';
import {controls} from '../style/controls.js';
import type {FoldTool} from '../../workbench/folding/fold-tool.js';
import type {FoldChooser} from '../../workbench/folding/fold-chooser.js';

/** Limits of the fabric in a pleat and of the length of a tuck. [cm] */
const limits = {uptake: [0.3, 40], length: [0.5, 300]} as const;

/** Sections through the fabric of each kind, from left to right, the face upwards. */
const sections: Readonly<Record<FoldKind, string>> = {
  knife: 'M1 11H21L9 7H31L19 3H39',
  box: 'M1 11H15L9 7M9 7V4H31V7M31 7 25 11H39',
  inverted: 'M1 4H19V7L9 11H31L21 7V4H39',
  tuck: 'M1 11H19V2M21 2V11H39M19 2Q20 1 21 2',
  roll: 'M1 11H16Q26 11 22 5T12 3',
  press: 'M1 12 20 3 39 12',
};

export class FoldBar extends WorkbenchElement {
  static override properties = {
    ...WorkbenchElement.properties,
    tool: {attribute: false},
    state: {attribute: false},
  };
  declare tool: FoldTool;
  /** State of the tool; the bar redraws after a change. */
  declare state: FoldChooser['state'];

  static override styles = [
    controls,
    css`
      :host {
        display: block;
      }
      /* one row of the same height, so that the pattern does not move under the next click */
      .bar {
        display: flex;
        align-items: end;
        gap: var(--sw-space-2);
        min-height: calc(var(--sw-target) + 1.6em);
        padding-bottom: 2px;
        overflow: auto hidden;
        white-space: nowrap;
      }
      .bar > * {
        flex: none;
      }
      label {
        display: grid;
        gap: var(--sw-space-1);
      }
      .check {
        display: flex;
        align-items: center;
        min-height: var(--sw-target);
      }
      button {
        padding: 0 var(--sw-space-2);
      }
      sw-number-field {
        width: 7rem;
      }
      svg {
        align-self: center;
        width: 40px;
        height: 14px;
        fill: none;
        stroke: currentColor;
        stroke-width: 1.5;
        stroke-linejoin: round;
      }
      .count {
        align-self: center;
        margin-left: auto;
        color: var(--sw-soft);
        white-space: nowrap;
      }
    `,
  ];

  protected override render(): TemplateResult {
    const {chooser, texts} = this.tool;
    const {fold, kind} = chooser;
    return html`<div class="bar" role="group" aria-label=${texts.bar}>
      <svg viewBox="0 0 40 14" aria-hidden="true">${svg`<path d=${sections[kind]}></path>`}</svg>
      ${this.#kinds(fold)} ${fold ? this.#size(fold) : nothing}
      ${chooser.hasMirror ? this.#mirrored() : nothing}
      ${fold ? this.#actions(fold) : this.#count()}
    </div>`;
  }

  #kinds(fold: DraftedFold | undefined): TemplateResult {
    const {chooser, texts} = this.tool;
    const isOffered = (kind: FoldKind): boolean =>
      !fold || hidesFabric(fold) === hidesFabric({kind});
    return html`<label>
      <span>${texts.kind}</span>
      <select
        @change=${({target}: Event) => {
          const {value} = target as HTMLSelectElement;
          const kind = foldKinds.find((one) => one === value);
          if (kind) chooser.setKind(kind);
        }}
      >
        ${foldKinds
          .filter(isOffered)
          .map(
            (kind) =>
              html`<option value=${kind} .selected=${kind === chooser.kind}>
                ${texts.kinds[kind]}
              </option>`,
          )}
      </select>
    </label>`;
  }

  #size(fold: DraftedFold): TemplateResult | typeof nothing {
    if (!hidesFabric(fold)) return nothing;
    const {chooser, texts} = this.tool;
    return html`${this.#length(texts.fabric, chooser.uptakeCm, limits.uptake, (cm) => {
      chooser.setUptake(cm);
    })}
    ${
      fold.kind === 'tuck'
        ? this.#length(texts.length, chooser.lengthCm, limits.length, (cm) => {
            chooser.setLength(cm);
          })
        : nothing
    }`;
  }

  #length(
    label: (unit: string) => string,
    value: number,
    range: readonly [number, number],
    enter: (cm: number) => void,
  ): TemplateResult {
    const {units} = this.workbench.preferences.chosen;
    const {format, texts, state: subject} = this;
    return lengthField({label, value, limits: range, subject, units, format, texts, enter});
  }

  #mirrored(): TemplateResult {
    const {chooser, texts} = this.tool;
    return html`<label class="check">
      <input
        type="checkbox"
        .checked=${chooser.isMirrored}
        @change=${({target}: Event) => {
          chooser.setMirrored((target as HTMLInputElement).checked);
        }}
      />
      ${texts.mirrored}
    </label>`;
  }

  #actions({kind}: DraftedFold): TemplateResult {
    const {chooser, texts} = this.tool;
    return html`${
      kind === 'knife' || kind === 'tuck'
        ? this.#button(`${texts.reverse} (R)`, texts.reverse, () => {
            chooser.reverse();
          })
        : nothing
    }
    ${this.#button(`${texts.remove} (Del)`, texts.remove, () => {
      chooser.remove();
    })}`;
  }

  #count(): TemplateResult {
    const {chooser, texts} = this.tool;
    const {length} = chooser.all;
    return html`${
        length > 0
          ? this.#button(`${texts.nextFold} (Tab)`, texts.nextFold, () => {
              chooser.walk(1);
            })
          : nothing
      }<span class="count">${texts.count(length)}</span>`;
  }

  #button(title: string, label: string, act: () => void): TemplateResult {
    return html`<button class="outlined" title=${title} @click=${act}>${label}</button>`;
  }
}
