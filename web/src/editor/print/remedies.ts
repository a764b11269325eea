/** Buttons for the repeats that make an image seamless. */
import {html, type TemplateResult} from 'lit';

import type {TileRepeat} from '../../model/print/opened-image.js';
import type {Texts} from '../../texts/en.js';

export const remedies = (
  {remedy, repeats: names}: Texts['print'],
  repeats: readonly TileRepeat[],
  take: (repeat: TileRepeat) => unknown,
): readonly TemplateResult[] =>
  repeats.map((repeat) => {
    const words = repeat === 'halfDrop' || repeat === 'brick' ? remedy[repeat] : remedy.mirror;
    return html`<button class="outlined" title=${names[repeat]} @click=${() => take(repeat)}>
      ${words}
    </button>`;
  });
