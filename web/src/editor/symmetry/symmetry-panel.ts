/** The kept symmetries, and found ones as proposals. */
import {css, html, nothing, type TemplateResult} from 'lit';

import {carries} from '../../model/print/repeat.js';
import type {Symmetry} from '../../model/garment/symmetries.js';
import {section} from '../controls/section.js';
import {WorkbenchElement} from '../base/workbench-element.js';
import {controls} from '../style/controls.js';
import {asked, withoutSymmetry, withSymmetry} from '../../workbench/symmetry-steps.js';

export class SymmetryPanel extends WorkbenchElement {
  static override styles = [
    controls,
    section,
    css`
      ul {
        display: grid;
        gap: var(--sw-space-1);
        margin: 0;
        padding: 0;
        list-style: none;
      }
      li {
        display: flex;
        align-items: baseline;
        justify-content: space-between;
        gap: var(--sw-space-3);
      }
      li button {
        min-width: var(--sw-target);
      }
      h3 {
        color: var(--sw-soft);
        font-weight: 400;
      }
    `,
  ];

  protected override render(): TemplateResult | typeof nothing {
    const {design} = this.workbench.history;
    const {kept, found} = this.workbench.solving;
    if (!design) return nothing;
    const {symmetry} = this.texts;
    return html`<section aria-label=${symmetry.list}>
      <h2>${symmetry.list}</h2>
      ${
        kept.length === 0
          ? html`<p class="soft">${symmetry.none}</p>`
          : this.#list(symmetry.kept, kept, symmetry.remove, (one) => {
              this.workbench.history.change(withoutSymmetry(kept, one));
            })
      }
      ${
        found.length === 0
          ? nothing
          : this.#list(
              symmetry.proposed,
              found,
              symmetry.accept,
              (_, k) => {
                const chosen = found[k];
                if (chosen) this.workbench.history.change(withSymmetry(kept, asked(chosen)));
              },
              ({kind}) => carries(design.print.group, kind),
            )
      }
      ${found.some(({kind}) => !carries(design.print.group, kind)) ? this.#uncarried() : nothing}
    </section>`;
  }

  #list(
    title: string,
    symmetries: readonly Symmetry[],
    label: string,
    act: (one: Symmetry, k: number) => void,
    canAct: (one: Symmetry) => boolean = () => true,
  ): TemplateResult {
    return html`<h3>${title}</h3>
      <ul>
        ${symmetries.map((one, k) => {
          const name = this.#name(one);
          return html`<li>
            <span>${name}</span>
            <button
              class="link"
              aria-label="${label}: ${name}"
              ?disabled=${!canAct(one)}
              @click=${() => {
                act(one, k);
              }}
            >
              ${label}
            </button>
          </li>`;
        })}
      </ul>`;
  }

  #uncarried(): TemplateResult {
    return html`<p class="soft">${this.texts.symmetry.wouldCarry}</p>`;
  }

  #name(one: Symmetry): string {
    const {symmetry} = this.texts;
    const label = (name: string): string =>
      this.workbench.sheet.scenes?.now.pieces.find((piece) => piece.name === name)?.label ??
      name.replaceAll('_', ' ');
    return one.kind === 'piece'
      ? symmetry.itself(label(one.piece))
      : symmetry.both(label(one.pieces[0]), label(one.pieces[1]));
  }
}
