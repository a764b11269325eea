/** The pattern: its drawing, the buttons over it, its legend, and the same as text for those who do not see it. */
import {css, html, nothing, type TemplateResult} from 'lit';

import type {PatternView} from '../../viewer/pattern-view.js';
import {DeskElement} from '../desk-element.js';
import {controls} from '../style/controls.js';
import {icon} from '../style/icons.js';
import {SceneMaker, type Scenes} from '../workbench/scenes.js';
import {tileOf} from './tile.js';

/** Begun at once: the drawing is the page's heaviest part. */
const drawing = import('../../viewer/pattern-view.js');

export class PatternPane extends DeskElement {
  static override styles = [
    controls,
    css`
      :host {
        display: grid;
        grid-template-rows: minmax(0, 1fr);
        position: relative;
        overflow: hidden;
        background: var(--sw-ground);
      }
      .application,
      .stage {
        position: absolute;
        inset: 0;
      }
      .application:focus-visible {
        outline-offset: -2px;
      }
      .view {
        position: absolute;
        right: var(--sw-space-3);
        bottom: var(--sw-space-3);
        display: flex;
        gap: 1px;
        padding: 2px;
        border: 1px solid var(--sw-line);
        border-radius: calc(var(--sw-radius) + 2px);
        background: var(--sw-paper);
      }
      .view button {
        width: 2rem;
        padding: 0;
      }
      .state {
        position: absolute;
        left: 50%;
        top: var(--sw-space-3);
        translate: -50% 0;
        padding: var(--sw-space-1) var(--sw-space-3);
        border: 1px solid var(--sw-line);
        border-radius: 2rem;
        background: var(--sw-paper);
        color: var(--sw-soft);
      }
    `,
  ];

  #view: PatternView | undefined;
  #noWebGl = false;
  readonly #maker = new SceneMaker();
  #shown: Scenes | undefined;
  /** Whose tile is shown, or being fetched. */
  #image: string | undefined;
  #dark = matchMedia('(prefers-color-scheme: dark)');
  #life: AbortController | undefined;

  override connectedCallback(): void {
    super.connectedCallback();
    this.#life = new AbortController();
    this.#dark.addEventListener(
      'change',
      () => {
        this.requestUpdate();
      },
      {signal: this.#life.signal},
    );
    void this.#open(this.#life.signal);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#life?.abort();
    this.#view?.dispose();
    this.#view = undefined;
    this.#image = undefined;
  }

  async #open(signal: AbortSignal): Promise<void> {
    const {PatternView} = await drawing;
    await this.updateComplete;
    const stage = this.renderRoot.querySelector<HTMLElement>('.stage');
    if (signal.aborted || !stage) return;
    try {
      this.#view = new PatternView(stage, {appearance: this.#appearance});
    } catch {
      this.#noWebGl = true;
    }
    stage.tabIndex = -1; // the pattern as a whole has the focus
    this.requestUpdate();
  }

  get #appearance(): 'light' | 'dark' {
    const {theme} = this.desk.preferences;
    if (theme !== 'system') return theme;
    return this.#dark.matches ? 'dark' : 'light';
  }

  protected override updated(): void {
    const view = this.#view;
    if (!view) return;
    view.setAppearance(this.#appearance);
    const {clientWidth: width, clientHeight: height} = this;
    this.#shown = this.#maker.scenes(this.desk, {width, height});
    if (this.#shown) view.show(this.#shown.now);
    this.desk.scenes = this.#shown;
    void this.#showTile(view);
  }

  async #showTile(view: PatternView): Promise<void> {
    const image = this.desk.design?.print.image;
    if (image === undefined || image === this.#image) return;
    this.#image = image;
    try {
      const tile = await tileOf(image, this.#life?.signal);
      if (this.#image === image) view.setTile(tile);
    } catch (error) {
      if (this.#image !== image || this.#life?.signal.aborted) return;
      view.setTile(undefined);
      this.desk.say({tone: 'error', text: error instanceof Error ? error.message : String(error)});
    }
  }

  protected override render(): TemplateResult {
    const {pattern} = this.texts;
    return html`
      <div class="application" role="application" aria-label=${pattern.label} tabindex="0">
        <div class="stage"></div>
      </div>
      ${this.#notice()}
      <div class="view" role="group" aria-label=${pattern.fit}>
        ${this.#button(pattern.zoomOut, icon.minus, () => this.#view?.zoomBy(1 / 1.4))}
        ${this.#button(pattern.fit, icon.fit, () => this.#view?.fit())}
        ${this.#button(pattern.zoomIn, icon.plus, () => this.#view?.zoomBy(1.4))}
      </div>
    `;
  }

  #notice(): TemplateResult | typeof nothing {
    const {pattern} = this.texts;
    if (this.#noWebGl) return html`<p class="state">${pattern.noWebGl}</p>`;
    if (this.desk.state.kind === 'stale') return html`<p class="state">${pattern.stale}</p>`;
    return nothing;
  }

  #button(label: string, picture: TemplateResult, act: () => void): TemplateResult {
    return html`<button aria-label=${label} title=${label} @click=${act}>${picture}</button>`;
  }
}

customElements.define('sw-pattern', PatternPane);
