/** Choice of a drawing's unit, with the size of its largest piece in each. */
import {html, nothing, type TemplateResult} from 'lit';

import {unitsInMetre, type FileUnit} from '../../model/garment/garment-document.js';
import type {Format} from '../../texts/format.js';
import type {ImportTexts} from '../../texts/import-texts.js';
import {largestOf} from './choices.js';
import type {ShownDrawing} from './reading.js';

const units = (Object.keys(unitsInMetre) as FileUnit[]).sort(
  (a, b) => unitsInMetre[b] - unitsInMetre[a],
);

export function unitChoice(
  shown: ShownDrawing,
  unit: FileUnit,
  choose: (unit: FileUnit) => void,
  words: ImportTexts,
  format: Format,
): TemplateResult {
  const {unit: guess} = shown.drawing;
  const isGuess = unit === guess.unit;
  const isDoubtful = isGuess && !guess.isSure;
  const how = words.unitIs[isGuess ? guess.because : 'chosen'](words.units[unit]);
  return html`<section class=${isDoubtful ? 'doubtful' : nothing}>
    <h3 id="unit">${words.unit}</h3>
    <p aria-live="polite">
      ${words.largest(format.length(largestOf(shown, unit)))}, ${how}
      ${isDoubtful ? words.doubtful : nothing}
    </p>
    <div class="units" role="group" aria-labelledby="unit">
      ${units.map(
        (one) =>
          html`<button
            class="outlined"
            data-unit=${one}
            aria-pressed=${one === unit}
            @click=${() => {
              choose(one);
            }}
          >
            <b>${words.units[one]}</b>
            <small>${format.length(largestOf(shown, one))}</small>
          </button>`,
      )}
    </div>
  </section>`;
}
