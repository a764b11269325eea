/** Dialog for the grain lines that a file lacks, with a proposal for each piece. */
import {css, html, nothing, type TemplateResult} from 'lit';

import type {DesignGarment} from '../../model/design/design.js';
import {WorkbenchElement} from '../base/workbench-element.js';
import {withGrainLines} from '../../workbench/lists/changed-options.js';
import {controls} from '../style/controls.js';
import {icon} from '../style/icons.js';
import {mirrorsOf} from '../../workbench/mirrors.js';
import {
  angleOfWay,
  grainProposals,
  grainWays,
  upwards,
  wayOf,
  withImage,
} from '../../workbench/tools/grain-proposals.js';

/** A piece that has no grain line yet. */
interface Asked {
  readonly piece: number;
  readonly name: string;
  readonly label: string;
  /** Proposed direction on the sheet. [degrees, face up] */
  readonly proposal: number;
  /** Rotation from the sheet to the coordinates of the piece. [degrees] */
  readonly turn: number;
}

/** An arrow along the grain. */
const arrow = (degrees: number): TemplateResult =>
  html`<svg viewBox="-8 -8 16 16" width="16" height="16" aria-hidden="true">
    <path
      d="M-6 0H6M3 -3 6 0 3 3"
      fill="none"
      stroke="currentColor"
      stroke-width="1.5"
      transform="rotate(${-degrees})"
    />
  </svg>`;

export class GrainQuestion extends WorkbenchElement {
  static override styles = [
    controls,
    css`
      .card {
        display: grid;
        gap: var(--sw-space-2);
        max-height: 40vh;
        overflow-y: auto;
        padding: var(--sw-space-2) var(--sw-space-4);
        border-bottom: 1px solid var(--sw-line);
        background: var(--sw-tint);
      }
      .row {
        display: flex;
        flex-wrap: wrap;
        align-items: center;
        gap: var(--sw-space-2);
      }
      .row > span {
        flex: 1 1 16rem;
      }
      ul {
        display: grid;
        grid-template-columns: repeat(auto-fill, minmax(min(20rem, 100%), 1fr));
        gap: var(--sw-space-1) var(--sw-space-4);
        margin: 0;
        padding: 0;
        list-style: none;
      }
      li {
        display: grid;
        grid-template-columns: 1rem minmax(0, 1fr) minmax(0, 12.5rem);
        align-items: center;
        gap: var(--sw-space-2);
      }
      label {
        display: contents;
      }
    `,
  ];

  /** Garment for which the user closed the dialog. */
  #later: DesignGarment | undefined;
  #isOpen = false;

  /** Returns the pieces without grain line; none if the result does not depend on the grain. */
  #asked(): readonly Asked[] {
    const {design} = this.workbench.history;
    const {scenes} = this.workbench.sheet;
    const {pattern} = this.workbench.solving;
    if (!design || !scenes || !pattern || design.garment === this.#later) return [];
    const {grain} = design.options;
    if ((grain?.default ?? 'free') === 'free' && !design.print.oneWay) return [];
    const proposals = grainProposals(
      pattern.pieces,
      scenes.marks,
      mirrorsOf(this.workbench.solving),
    );
    return scenes.now.pieces.flatMap(({name, label, plain, isTurned}, piece): Asked[] => {
      const turn = isTurned ? 180 : 0;
      const proposal = proposals.get(name);
      const isSaid = scenes.marks.get(name)?.grainDeg !== undefined;
      if (plain || isSaid || proposal === undefined) return [];
      return [{piece, name, label, turn, proposal: (proposal + turn) % 360}];
    });
  }

  protected override render(): TemplateResult | typeof nothing {
    const asked = this.#asked();
    this.toggleAttribute('asks', asked.length > 0); // the layout of the editor makes room
    if (asked.length === 0) return nothing;
    const {grain} = this.texts;
    const turned = asked.filter(({proposal}) => wayOf(proposal) !== 'up').length;
    const all = this.workbench.sheet.scenes?.now.pieces.length ?? 0;
    return html`<div class="card" role="region" aria-label=${grain.title}>
      <div class="row">
        <span role="status"
          >${asked.length === all ? grain.none : grain.some(asked.length)}
          ${turned === 0 ? grain.asDrawn : grain.turned(turned)}</span
        >
        <button
          class="primary"
          @click=${() => {
            this.#say(asked.map((one) => ({...one, degrees: one.proposal})));
          }}
        >
          ${grain.takeAll}
        </button>
        ${
          turned === 0
            ? nothing
            : html`<button
                class="outlined"
                @click=${() => {
                  this.#say(asked.map((one) => ({...one, degrees: upwards})));
                }}
              >
                ${grain.allUp}
              </button>`
        }
        <button
          class="outlined"
          aria-expanded=${this.#isOpen}
          @click=${() => {
            this.#isOpen = !this.#isOpen;
            this.requestUpdate();
          }}
        >
          ${grain.each}
        </button>
        <button
          class="icon"
          aria-label=${grain.later}
          title=${grain.later}
          @click=${() => {
            this.#later = this.workbench.history.design?.garment;
            this.requestUpdate();
          }}
        >
          ${icon.close}
        </button>
      </div>
      ${
        this.#isOpen
          ? html`<ul>
              ${asked.map((one) => this.#row(one))}
            </ul>`
          : nothing
      }
    </div>`;
  }

  #row(one: Asked): TemplateResult {
    const {piece, label, proposal} = one;
    const {grain} = this.texts;
    const to = Math.round(proposal);
    const directions: Readonly<Record<number, string>> = grain.directions;
    return html`<li
      @pointerenter=${() => {
        this.workbench.selection.point({kind: 'piece', piece});
      }}
    >
      ${arrow(proposal)}
      <label
        ><span>${label}</span>
        <select
          @focus=${() => {
            this.workbench.selection.select({kind: 'piece', piece});
          }}
          @change=${({target}: Event) => {
            const {value} = target as HTMLSelectElement;
            const chosen = grainWays.find((way) => way === value);
            if (value === 'clicks') this.#click(piece);
            else if (chosen) this.#sayMirrored(one, angleOfWay[chosen]);
            else if (value === 'proposal') this.#sayMirrored(one, proposal);
          }}
        >
          <option value="" selected>${grain.proposal(directions[to] ?? grain.other(to))}</option>
          <option value="proposal">${grain.take}</option>
          ${grainWays.map((way) => html`<option value=${way}>${grain.ways[way]}</option>`)}
          <option value="clicks">${grain.clicks}</option>
        </select></label
      >
    </li>`;
  }

  /** @param degrees direction on the sheet */
  #sayMirrored({name, turn}: Asked, degrees: number): void {
    this.#take(withImage(name, (degrees + turn) % 360, mirrorsOf(this.workbench.solving)));
  }

  /** Sets the grain line of each piece separately; `degrees` is its direction on the sheet. */
  #say(lines: readonly (Asked & {readonly degrees: number})[]): void {
    this.#take(
      Object.fromEntries(lines.map(({name, turn, degrees}) => [name, (degrees + turn) % 360])),
    );
  }

  #take(lines: Readonly<Record<string, number>>): void {
    const {design} = this.workbench.history;
    if (design) this.workbench.history.change({options: withGrainLines(design.options, lines)});
  }

  #click(piece: number): void {
    this.workbench.selection.select({kind: 'piece', piece});
    this.dispatchEvent(new CustomEvent('sw-grain-wanted', {bubbles: true, composed: true}));
  }
}
