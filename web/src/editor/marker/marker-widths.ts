/** Table of the lengths that the same pieces need on fabric of other widths. */
import {html, nothing, type TemplateResult} from 'lit';

import type {LayPlan} from '../../model/result/marker-plan.js';
import type {Units} from '../../model/base/length-text.js';
import type {Format} from '../../texts/format.js';
import type {ClothTexts} from '../../texts/marker-texts.js';
import {roundedLength} from '../../workbench/marker/marker-words.js';

interface Widths {
  readonly units: Units;
  readonly words: ClothTexts;
  readonly format: Format;
  /** Note on the lengths if they do not apply to the pieces as laid. */
  readonly of: string | undefined;
  /** Lays the pieces on fabric of this width. [cm] */
  readonly take: (widthCm: number) => void;
}

export function markerWidths(
  {widths, widthCm}: LayPlan,
  {units, words, format, of, take}: Widths,
): TemplateResult | typeof nothing {
  if (!widths.some(({lengthCm}) => lengthCm !== null)) return nothing;
  return html`<table class="widths">
    <caption>
      ${words.widths} ${of === undefined ? nothing : html`<span class="of">${of}</span>`}
    </caption>
    <thead>
      <tr>
        <th scope="col">${words.widthColumn}</th>
        <th scope="col" class="number">${words.lengthColumn}</th>
      </tr>
    </thead>
    <tbody>
      ${widths.map(({widthCm: width, lengthCm}) => {
        const label = format.length(width);
        return html`<tr class=${width === widthCm ? 'present' : ''}>
          <th scope="row">
            ${
              width === widthCm || lengthCm === null
                ? label
                : html`<button
                    class="link"
                    aria-label=${words.takeWidth(label)}
                    title=${words.takeWidth(label)}
                    @click=${() => {
                      take(width);
                    }}
                  >
                    ${label}
                  </button>`
            }
          </th>
          <td class="number">
            ${lengthCm === null ? words.nowhere : roundedLength(lengthCm, units, format)}
          </td>
        </tr>`;
      })}
    </tbody>
  </table>`;
}
