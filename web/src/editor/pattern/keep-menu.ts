/** List of the selected piece's edges, to keep them as drafted without a pointer. */
import {css, html, nothing, type TemplateResult} from 'lit';

import {isKept, keptParts} from '../../model/design/locks.js';
import type {MeshedPattern} from '../../model/result/result.js';
import {lengthOf} from '../../model/geometry/polyline.js';
import {pick} from '../../scene/marks.js';
import {WorkbenchElement} from '../base/workbench-element.js';
import {seamRows} from '../../workbench/lists/rows.js';
import {controls} from '../style/controls.js';
import {togglePart} from '../../workbench/tools/keeping.js';

interface Edge {
  readonly edge: number;
  readonly name: string;
}

export class KeepMenu extends WorkbenchElement {
  static override styles = [
    controls,
    css`
      [popover] {
        max-height: 60dvh;
        overflow-y: auto;
      }
      [popover]:popover-open {
        display: grid;
        gap: var(--sw-space-1);
      }
      label {
        min-height: 1.75rem;
        align-items: center;
      }
    `,
  ];

  constructor() {
    super();
    // a click here does not focus the pattern, whose keys would close the tool with the list
    this.addEventListener('click', (event) => {
      event.stopPropagation();
    });
  }

  protected override render(): TemplateResult | typeof nothing {
    const {selected} = this.workbench.selection;
    const {scenes} = this.workbench.sheet;
    const {design} = this.workbench.history;
    const {pattern} = this.workbench.solving;
    const number = selected?.kind === 'piece' ? selected.piece : -1;
    const piece = scenes?.now.pieces[number];
    if (!design || !pattern || !piece) return nothing;
    const {keep} = this.texts;
    const parts = keptParts(pattern, design.options.locked);
    const box = (edge: number | undefined, name: string): TemplateResult =>
      html`<label class="inline">
        <input
          type="checkbox"
          .checked=${isKept(parts, {piece: number, edge})}
          @change=${() => {
            togglePart(this.workbench, {piece: number, edge});
          }}
        />
        ${name}
      </label>`;
    return html`<button class="outlined" popovertarget="edges">${keep.edges(piece.label)}</button>
      <div
        id="edges"
        popover
        role="group"
        aria-label=${keep.edges(piece.label)}
        @keydown=${(event: KeyboardEvent) => {
          if (event.key === 'Escape') event.stopPropagation(); // closes the list, not the tool
        }}
        @beforetoggle=${({currentTarget}: Event) => {
          this.#place(currentTarget as HTMLElement);
        }}
      >
        ${box(undefined, keep.whole)}
        ${this.#edges(pattern, number).map(({edge, name}) => box(edge, name))}
      </div>`;
  }

  /** Places the list above its button, which is at the foot of the pattern. */
  #place(panel: HTMLElement): void {
    const at = this.renderRoot.querySelector('button')?.getBoundingClientRect();
    if (!at) return;
    panel.style.position = 'fixed';
    panel.style.inset = `auto auto ${innerHeight - at.top + 4}px max(4px, min(${at.left}px, 100vw - 20rem))`;
    panel.style.maxWidth = 'min(20rem, 100vw - 8px)';
  }

  /** Returns the edges in the order of the outline; sewn edges have the names of their seams. */
  #edges({pieces, seams}: MeshedPattern, piece: number): readonly Edge[] {
    const {outline = [], edges = [], rest = []} = pieces[piece] ?? {};
    const rows = seamRows(this.workbench, this.texts);
    const names = new Map<string, string>();
    seams.forEach(({a, b}, seam) => {
      for (const side of [a, b]) {
        if (side.piece !== piece) continue;
        const {vertices} = side;
        vertices.slice(1).forEach((v, k) => {
          for (const ends of [
            [vertices[k], v],
            [v, vertices[k]],
          ])
            names.set(ends.join(' '), rows[seam]?.name ?? '');
        });
      }
    });
    return [...new Set(edges)].map((edge) => {
      const ways = outline.flatMap((from, k) =>
        edges[k] === edge ? [[from, outline[(k + 1) % outline.length] ?? from] as const] : [],
      );
      const sewn = ways.map((ends) => names.get(ends.join(' '))).find((name) => name);
      const length = ways.reduce((sum, ends) => sum + lengthOf(pick(rest, ends)), 0);
      return {edge, name: sewn ?? this.texts.keep.openEdge(this.format.length(length))};
    });
  }
}
