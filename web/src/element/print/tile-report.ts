/** Somebody's own picture beside the group it is used with: whether it has that, and where it breaks it. */
import {css, html, nothing, svg, type TemplateResult} from 'lit';

import {noPicture, type DesignPrint} from '../../model/design.js';
import type {FoundGroup, TileBreak, TileCheck} from '../../picture/tile-check.js';
import {DeskElement} from '../desk-element.js';
import {controls} from '../style/controls.js';
import {missing} from './choices.js';
import {checked, groupsIn, withFound} from './own-print.js';

interface Report {
  readonly print: DesignPrint;
  readonly check: TileCheck;
  readonly groups: readonly FoundGroup[];
}

/** The outline of places that touch: the sides that no two of them share. */
function outlineOf(breaks: readonly TileBreak[]): string {
  const sides = new Map<string, number>();
  for (const {x, y, width, height} of breaks) {
    const [left, right] = [x, x + width].map((value) => value.toFixed(4));
    const [top, bottom] = [y, y + height].map((value) => value.toFixed(4));
    for (const side of [
      `M${left} ${top}H${right}`,
      `M${left} ${bottom}H${right}`,
      `M${left} ${top}V${bottom}`,
      `M${right} ${top}V${bottom}`,
    ]) {
      sides.set(side, (sides.get(side) ?? 0) + 1);
    }
  }
  return Array.from(sides)
    .filter(([, times]) => times === 1)
    .map(([side]) => side)
    .join('');
}

export class TileReport extends DeskElement {
  static override properties = {...DeskElement.properties, report: {state: true}};
  declare protected report: Report | undefined;
  #looked: DesignPrint | undefined;

  static override styles = [
    controls,
    css`
      :host {
        display: grid;
        gap: var(--sw-space-2);
      }
      .breaks {
        display: grid;
        grid-template-columns: 7rem 1fr;
        gap: var(--sw-space-3);
        padding: var(--sw-space-3);
        border-radius: var(--sw-radius);
        background: var(--sw-bad-tint);
      }
      .breaks > div {
        display: grid;
        align-content: start;
        gap: var(--sw-space-2);
      }
      .row {
        display: flex;
        flex-wrap: wrap;
        gap: var(--sw-space-1) var(--sw-space-2);
      }
      svg {
        width: 100%;
        max-height: 10rem;
      }
      path {
        fill: none;
        stroke-linecap: square;
        vector-effect: non-scaling-stroke;
      }
      .casing {
        stroke: #fff;
        stroke-width: 5;
      }
      .line {
        stroke: #a92a22;
        stroke-width: 2;
      }
    `,
  ];

  protected override updated(): void {
    const print = this.desk.design?.print;
    if (!print || print === this.#looked) return;
    this.#looked = print;
    if (print.image === noPicture) return;
    this.#look(print).catch(() => undefined); // who draws the picture says that it cannot be read
  }

  protected override render(): TemplateResult | typeof nothing {
    const print = this.desk.design?.print;
    if (!print) return nothing;
    const texts = this.texts.print;
    if (print.image === noPicture) return html`<p role="status">${texts.needsPicture}</p>`;
    const {report} = this;
    if (report?.print !== print) return nothing;
    const {check, groups} = report;
    if (check.breaks.length === 0) {
      if (print.group === 'p1') return nothing; // which asks for nothing
      return html`<p role="status" class="soft">${texts.keeps(print.group)}</p>`;
    }
    return html`<div class="breaks" role="status">
      ${this.#picture(print, check)}
      <div>
        <p>${texts.breaks(print.group, this.format.percent(check.worst / 255))}</p>
        <p>${texts.has}</p>
        <div class="row">${groups.map((found) => this.#found(print, found))}</div>
      </div>
    </div>`;
  }

  #picture({image, size, title}: DesignPrint, {breaks}: TileCheck): TemplateResult {
    const outline = outlineOf(breaks);
    const proportion = size.height / size.width;
    return html`<svg viewBox="0 0 1 ${proportion}" role="img" aria-label=${title}>
      ${svg`<image href=${image} width="1" height=${proportion} preserveAspectRatio="none"></image>
        <g transform="scale(1 ${proportion})">
          <path class="casing" d=${outline}></path>
          <path class="line" d=${outline}></path>
        </g>`}
    </svg>`;
  }

  #found(print: DesignPrint, found: FoundGroup): TemplateResult {
    const lacks = missing(found.group, this.desk.design?.symmetries ?? []);
    return html`<button
      class="outlined"
      ?disabled=${lacks !== undefined}
      title=${this.texts.print.meanings[found.group]}
      @click=${() => this.#take(print, found)}
    >
      ${found.group}
    </button>`;
  }

  async #look(print: DesignPrint): Promise<void> {
    const [check, groups] = await Promise.all([
      checked(print),
      groupsIn(print.image, print.size.width),
    ]);
    if (this.#looked === print) this.report = {print, check, groups};
  }

  async #take(print: DesignPrint, found: FoundGroup): Promise<void> {
    const taken = await withFound(print, found);
    if (this.desk.design?.print === print) this.desk.change({print: taken});
  }
}
