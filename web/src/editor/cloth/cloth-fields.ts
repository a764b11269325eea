/** What is said of the cloth: its width, its edges, which way up, and where its print starts. */
import {html, nothing, type TemplateResult} from 'lit';

import {clothLimits, usualWidths, type ClothChoices} from '../../workbench/cloth-choices.js';
import type {Units} from '../../model/units.js';
import type {ClothTexts} from '../../texts/cloth-texts.js';
import type {Format} from '../../texts/format.js';
import type {Texts} from '../../texts/texts.js';
import {lengthUnit} from '../controls/number-field.js';

interface Fields {
  readonly choices: ClothChoices;
  /** Where the print starts in the plan that is shown. [cm] */
  readonly startCm: number | undefined;
  /** Somebody wants to enter a width of their own. */
  readonly hasOwnWidth: boolean;
  /** The print looks different upside down. */
  readonly isOneWay: boolean;
  readonly units: Units;
  readonly format: Format;
  readonly texts: Texts;
  readonly words: ClothTexts;
  readonly choose: (change: Partial<ClothChoices>) => void;
  readonly askOwnWidth: () => void;
}

const other = 'other';

const chosen = (event: Event): string => (event.target as HTMLSelectElement).value;

function lengthField(
  {units, format, texts, choices, choose}: Fields,
  name: keyof typeof clothLimits,
  label: (unit: string) => string,
): TemplateResult {
  const {name: unit, cm} = lengthUnit[units];
  const [least, most] = clothLimits[name];
  return html`<sw-number-field
    .label=${label(unit)}
    .value=${(choices[name] ?? 0) / cm}
    .least=${least / cm}
    .most=${most / cm}
    .step=${name === 'gapCm' ? 0.1 : 0.5}
    .digits=${units === 'inch' ? 3 : 1}
    .fractions=${units === 'inch'}
    .wrong=${texts.controls.between(format.length(least), format.length(most))}
    @entered=${({detail}: CustomEvent<number>) => {
      choose({[name]: detail * cm});
    }}
  ></sw-number-field>`;
}

function widthField(fields: Fields): TemplateResult {
  const {choices, format, words, choose, hasOwnWidth, askOwnWidth} = fields;
  const isOwn = hasOwnWidth || !usualWidths.includes(choices.widthCm);
  return html`<label>
      ${words.width}
      <select
        class="width"
        @change=${(event: Event) => {
          const value = chosen(event);
          if (value === other) askOwnWidth();
          else choose({widthCm: Number(value)});
        }}
      >
        ${usualWidths.map(
          (width) =>
            html`<option value=${width} .selected=${!isOwn && width === choices.widthCm}>
              ${format.length(width)}
            </option>`,
        )}
        <option value=${other} .selected=${isOwn}>${words.otherWidth}</option>
      </select>
    </label>
    ${isOwn ? lengthField(fields, 'widthCm', words.widthIn) : nothing}`;
}

function phaseField(fields: Fields): TemplateResult {
  const {choices, startCm = 0, words, choose} = fields;
  const isKnown = choices.phaseCm !== null;
  return html`<label>
      ${words.phase}
      <select
        class="phase"
        @change=${(event: Event) => {
          choose({phaseCm: chosen(event) === 'known' ? Math.max(0, startCm) : null});
        }}
      >
        ${(['unknown', 'known'] as const).map(
          (name) =>
            html`<option value=${name} .selected=${isKnown === (name === 'known')}>
              ${words.phases[name]}
            </option>`,
        )}
      </select>
    </label>
    ${isKnown ? lengthField(fields, 'phaseCm', words.phaseIn) : nothing}`;
}

export function clothFields(fields: Fields): TemplateResult {
  const {choices, words, choose, isOneWay} = fields;
  return html`<div class="fields">
    ${widthField(fields)}
    <div class="beside">
      ${lengthField(fields, 'selvedgeCm', words.selvedge)}
      ${lengthField(fields, 'gapCm', words.gap)}
    </div>
    ${phaseField(fields)}
    <div>
      <label class="inline">
        <input
          type="checkbox"
          aria-describedby="nap"
          .checked=${choices.isOneWay || isOneWay}
          ?disabled=${isOneWay}
          @change=${({target}: Event) => {
            choose({isOneWay: (target as HTMLInputElement).checked});
          }}
        />
        ${words.oneWay}
      </label>
      <p id="nap" class="soft note">${words.oneWayNote}</p>
    </div>
  </div>`;
}
