/**
 * Close-up of a seam: names of both sides, a ruler below, and a handle between before and after.
 */
import {css, html, nothing, svg, type PropertyValues, type TemplateResult} from 'lit';

import type {SeamStrip, ShownSeam} from '../../viewer/seam-strip.js';
import {AppearanceController, colourScheme} from '../base/appearance.js';
import {WorkbenchElement, PatientElement} from '../base/workbench-element.js';
import type {SeamRow} from '../../workbench/lists/rows.js';
import type {LensCursor} from '../../workbench/tools/pattern-marks.js';
import {controls} from '../style/controls.js';
import {rulerOf} from '../../scene/ruler.js';

/**
 * Fires `sw-lens-cursor` with the position of the pointer along the seam; undefined off the seam.
 */
export class LensStrip extends PatientElement {
  static override properties = {...WorkbenchElement.properties, row: {attribute: false}};
  declare row: SeamRow;

  static override styles = [
    controls,
    colourScheme,
    css`
      :host {
        display: grid;
        grid-template-rows: minmax(0, 1fr) 0.75rem;
      }
      .frame,
      svg {
        margin-inline: var(--sw-space-4); /* the handle reaches beyond */
      }
      .frame {
        position: relative;
        border-radius: var(--sw-radius);
        background: var(--sw-ground);
      }
      .stage {
        position: absolute;
        inset: 0;
        overflow: hidden;
        border-radius: inherit;
      }
      /* the picture of another seam is hidden, but not for a frame or two */
      .late {
        opacity: 0;
        transition: opacity 0s 80ms;
      }
      .side {
        position: absolute;
        right: var(--sw-space-1);
        max-width: 70%;
        padding: 0 var(--sw-space-1);
        overflow: hidden;
        border-radius: 4px;
        background: var(--sw-paper);
        font-size: var(--sw-text);
        text-overflow: ellipsis;
        white-space: nowrap;
        pointer-events: none;
      }
      .a {
        top: var(--sw-space-1);
      }
      .b {
        bottom: var(--sw-space-1);
      }
      svg {
        display: block;
        height: 100%;
        fill: none;
        stroke: var(--sw-strong-line);
      }
      p {
        padding: var(--sw-space-2);
      }
    `,
  ];

  #strip: SeamStrip | undefined;
  #shown: ShownSeam | undefined;
  #noWebGl = false;
  /** True while the picture is that of another seam than the words. */
  #isLate = false;
  /** The strip shows the seam before the alignment left of here. [share of the width] */
  #split = 0;
  /** Image of the tile that is displayed or being fetched. */
  #image: string | undefined;
  readonly #appearance = new AppearanceController(this);
  #life: AbortController | undefined;

  override connectedCallback(): void {
    super.connectedCallback();
    this.#life = new AbortController();
    const {signal} = this.#life;
    const resized = new ResizeObserver(() => {
      this.requestUpdate();
    });
    resized.observe(this);
    signal.addEventListener('abort', () => {
      resized.disconnect();
    });
    void this.#open(signal);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#life?.abort();
    this.#strip?.dispose();
    this.#strip = undefined;
    this.#shown = undefined;
    this.#image = undefined;
  }

  async #open(signal: AbortSignal): Promise<void> {
    const {SeamStrip} = await import('../../viewer/seam-strip.js');
    await this.updateComplete;
    const stage = this.renderRoot.querySelector<HTMLElement>('.stage');
    if (signal.aborted || !stage) return;
    try {
      this.#strip = new SeamStrip(stage, {
        appearance: this.#appearance.value,
        painted: () => {
          if (this.#isLate) this.requestUpdate();
        },
      });
    } catch {
      this.#noWebGl = true;
    }
    this.requestUpdate();
  }

  /** Updates the drawing before the ruler is rendered, since the ruler depends on its scale. */
  protected override willUpdate(changed: PropertyValues<this>): void {
    super.willUpdate(changed);
    const strip = this.#strip;
    const {scenes} = this.workbench.sheet;
    if (!strip || !scenes) return;
    strip.setAppearance(this.#appearance.value);
    const {seam} = this.row;
    if (scenes.now !== this.#shown?.scene || seam !== this.#shown.seam) {
      this.#shown = {scene: scenes.now, seam};
      strip.show(this.#shown);
    }
    strip.setWipe(this.#split > 0 ? {before: scenes.before, split: this.#split} : undefined);
    this.#isLate = !strip.isCurrent;
    void this.#showTile(strip);
  }

  async #showTile(strip: SeamStrip): Promise<void> {
    const image = this.workbench.history.design?.print.image;
    if (image === undefined || image === this.#image) return;
    this.#image = image;
    // the pattern shows the message for an unreadable image
    const tile = await this.workbench.tileOf(image, this.#life?.signal).catch(() => undefined);
    if (this.#image === image) strip.setTile(tile);
  }

  protected override render(): TemplateResult {
    const [above, below] = this.row.sides;
    return html`
      <div
        class="frame"
        @pointermove=${(event: PointerEvent) => {
          this.#point(event);
        }}
        @pointerleave=${() => {
          this.#tell(undefined);
        }}
      >
        <div class=${this.#isLate ? 'late stage' : 'stage'}></div>
        <span class="side a">${above}</span><span class="side b">${below}</span>
        ${
          this.#noWebGl
            ? html`<p class="soft">${this.texts.pattern.noWebGl}</p>`
            : html`<sw-wipe-handle
                bare
                .workbench=${this.workbench}
                .split=${this.#split}
                @input=${({detail}: CustomEvent<number>) => {
                  this.#split = detail;
                  this.requestUpdate();
                }}
              ></sw-wipe-handle>`
        }
      </div>
      ${this.#ruler()}
    `;
  }

  #ruler(): TemplateResult | typeof nothing {
    const strip = this.#strip;
    if (!strip) return nothing;
    const [from, to] = strip.span;
    const {units} = this.workbench.preferences.chosen;
    const {step, ticks} = rulerOf(from, to - from, strip.scale, units);
    const name = this.texts.lens.ruler(this.format.length(step));
    const path = ticks.map((x, k) => `M${x.toFixed(1)} 2v${k % 5 === 0 ? 8 : 5}`).join('');
    return html`<svg role="img" aria-label=${name}>
      ${svg`<title>${name}</title><path d=${path} />`}
    </svg>`;
  }

  #point(event: PointerEvent): void {
    const {currentTarget: frame, clientX, clientY} = event;
    if (!(frame instanceof HTMLElement)) return;
    const {left, top} = frame.getBoundingClientRect();
    const near = this.#strip?.pieceAt(clientX - left, clientY - top);
    this.#tell(
      near && near.share >= 0 && near.share <= 1
        ? {seam: this.row.seam, share: near.share}
        : undefined,
    );
  }

  #tell(detail: LensCursor | undefined): void {
    this.#strip?.setCursor(detail?.share);
    this.dispatchEvent(new CustomEvent('sw-lens-cursor', {detail, bubbles: true, composed: true}));
  }
}
