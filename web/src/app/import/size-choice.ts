/** Choice of a size, for a drawing with several. */
import {html, nothing, type TemplateResult} from 'lit';

import type {Drawing} from '../../model/garment/imported-drawing.js';
import type {ImportTexts} from '../../texts/import-texts.js';

/** @param isWaiting true while another size is being read */
export function sizeChoice(
  {sizes, sampleSize, size = sampleSize}: Drawing,
  isWaiting: boolean,
  choose: (size: string) => void,
  words: ImportTexts,
): TemplateResult | typeof nothing {
  if (sizes.length < 2) return nothing;
  return html`<section>
    <label>
      ${words.size}
      <select
        ?disabled=${isWaiting}
        @change=${({target}: Event) => {
          choose((target as HTMLSelectElement).value);
        }}
      >
        ${sizes.map(
          (one) =>
            html`<option value=${one} ?selected=${one === size}>
              ${one === sampleSize ? words.sample(one) : one}
            </option>`,
        )}
      </select>
    </label>
  </section>`;
}
