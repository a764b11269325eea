/** Choices of the scale of a drawing: pixels per inch, and 1 : n. */
import {html, nothing, type TemplateResult} from 'lit';

import {densities} from '../../files/base/units.js';
import type {Drawing, DrawingOptions} from '../../model/garment/imported-drawing.js';
import type {ImportTexts} from '../../texts/import-texts.js';
import type {Texts} from '../../texts/texts.js';

/** Scales 1 : n from an enlarged drawing to a small one in a book. */
const [leastScale, mostScale] = [0.01, 100];

interface ScaleChoice {
  readonly drawing: Drawing;
  readonly options: DrawingOptions;
  /** True while the file is being read again. */
  readonly isBusy: boolean;
  readonly words: ImportTexts;
  readonly texts: Texts;
  /** Reads the file again with other options. */
  readonly choose: (change: DrawingOptions) => void;
}

/** OBJ has the size of its garment. */
export function scaleChoice(of: ScaleChoice): TemplateResult | typeof nothing {
  const {drawing, options, words, texts, choose} = of;
  if (drawing.kind === 'obj') return nothing;
  return html`<section>
    ${drawing.kind === 'svg' ? densityChoice(of) : nothing}
    <sw-number-field
      .label=${words.scale}
      .value=${options.scale ?? 1}
      .least=${leastScale}
      .most=${mostScale}
      .step=${1}
      .digits=${2}
      .wrong=${texts.controls.between(String(leastScale), String(mostScale))}
      @entered=${({detail}: CustomEvent<number>) => {
        choose({scale: detail});
      }}
    ></sw-number-field>
  </section>`;
}

/** Choice of the pixels per inch of an SVG file. */
function densityChoice({options, isBusy, words, choose}: ScaleChoice): TemplateResult {
  const density = options.pixelsPerInch;
  return html`<label>
    ${words.density}
    <select
      ?disabled=${isBusy}
      @change=${({target}: Event) => {
        const {value} = target as HTMLSelectElement;
        choose(value === '' ? {} : {pixelsPerInch: Number(value)});
      }}
    >
      <option value="" ?selected=${density === undefined}>${words.asInFile}</option>
      ${densities.map(
        (one) => html`<option value=${one} ?selected=${one === density}>${String(one)}</option>`,
      )}
    </select>
  </label>`;
}
