/**
 * Preview of the print: three repeats of its tile, and the places that break the chosen symmetry.
 */
import {css, html, nothing, type PropertyValues, type TemplateResult} from 'lit';

import type {TileBreak} from '../../image/tile-check.js';
import {printOf, type DesignPrint} from '../../model/design/design.js';
import {outlineOf, markedTile, markedTileStyle} from '../print/marked-tile.js';
import {swatch} from '../print/swatch.js';
import {controls} from '../style/controls.js';
import {brokenPlaces, type BrokenPlaces} from '../../photo/breaks-on-photo.js';
import {PhotoElement} from './photo-element.js';
import {cellPicture, pngOf} from '../../photo/photo-picture.js';
import {groupIn, measuresOf, tileSettings} from '../../photo/photo-step.js';

/** Changes within this time are shown together. [ms] */
const pause = 250;
const repeats = 3;
/** Longest side of the compared image. [px] */
const compared = 320;

interface Shown {
  readonly print: DesignPrint;
  readonly breaks: readonly TileBreak[];
}

/** Fires `broken` with `BrokenPlaces`, or without detail if the symmetry holds. */
export class PhotoSwatch extends PhotoElement {
  static override properties = {
    ...PhotoElement.properties,
    shown: {state: true},
    isStale: {state: true},
  };
  static override styles = [
    controls,
    markedTileStyle,
    css`
      :host {
        display: grid;
        gap: var(--sw-space-2);
      }
      .swatch svg {
        display: block;
        width: 100%;
        aspect-ratio: 1.6;
        border: 1px solid var(--sw-line);
        border-radius: var(--sw-radius);
      }
      .stale {
        opacity: 0.5;
      }
    `,
  ];
  declare protected shown: Shown | undefined;
  declare protected isStale: boolean;
  #key = '';
  #timer: ReturnType<typeof setTimeout> | undefined;

  constructor() {
    super();
    this.isStale = false;
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    clearTimeout(this.#timer);
    this.#show(undefined);
    this.#key = '';
  }

  protected override willUpdate(changed: PropertyValues<this>): void {
    super.willUpdate(changed);
    const {step, state} = this.session.read;
    if (!step || state.kind === 'reading') return;
    const key = JSON.stringify([tileSettings(step), measuresOf(step)]);
    if (key === this.#key) return;
    this.#key = key;
    this.isStale = true;
    this.#tell(undefined); // they belong to another cell
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => void this.#make(key), pause);
  }

  protected override render(): TemplateResult {
    const {words, shown, isStale} = this;
    const kind = shown ? this.texts.print.kinds[shown.print.group] : '';
    return html`<div
        class="swatch ${isStale ? 'stale' : ''}"
        role="img"
        aria-label=${words.swatch}
        aria-busy=${isStale ? 'true' : 'false'}
      >
        ${shown ? swatch('swatch', printOf(shown.print), shown.print.image, repeats) : nothing}
      </div>
      ${isStale ? html`<p class="soft" role="status">${words.making}</p>` : nothing}
      ${
        shown && shown.breaks.length > 0
          ? html`<div class="breaks">
              ${markedTile({
                ...{image: shown.print.image, size: shown.print.size, turnDeg: 0},
                ...{marks: outlineOf(shown.breaks), label: words.breaks(kind)},
              })}
              <div><p>${words.breaks(kind)}</p></div>
            </div>`
          : nothing
      }`;
  }

  async #make(key: string): Promise<void> {
    const {step} = this.session;
    if (!step) return;
    try {
      const tile = await this.session.tile();
      const measures = measuresOf(step);
      const canvas = cellPicture(tile, measures);
      const [blob, breaks] = await Promise.all([
        pngOf(canvas),
        !step.isExact && groupIn(step).verdict !== 'has' ? breaksIn(canvas, measures) : [],
      ]);
      if (key !== this.#key || !this.isConnected) return;
      this.#show({print: {...measures, title: '', image: URL.createObjectURL(blob)}, breaks});
      this.isStale = false;
    } catch {
      if (key === this.#key) this.#key = ''; // the error appears when the print is made
    }
  }

  #show(next: Shown | undefined): void {
    if (this.shown) URL.revokeObjectURL(this.shown.print.image);
    this.shown = next;
    const isBroken = next && next.breaks.length > 0;
    this.#tell(isBroken ? brokenPlaces(next.breaks, next.print) : undefined);
  }

  #tell(detail: BrokenPlaces | undefined): void {
    this.dispatchEvent(new CustomEvent('broken', {detail}));
  }
}

async function breaksIn(
  canvas: OffscreenCanvas,
  {group, size, cell}: ReturnType<typeof measuresOf>,
): Promise<readonly TileBreak[]> {
  const {checkTile} = await import('../../image/tile-check.js');
  const scale = Math.min(1, compared / Math.max(canvas.width, canvas.height));
  const small = new OffscreenCanvas(
    Math.max(1, Math.round(scale * canvas.width)),
    Math.max(1, Math.round(scale * canvas.height)),
  );
  const context = small.getContext('2d', {willReadFrequently: true});
  if (!context) return [];
  context.drawImage(canvas, 0, 0, small.width, small.height);
  const pixels = context.getImageData(0, 0, small.width, small.height);
  return checkTile(pixels, group, size, cell).breaks;
}
