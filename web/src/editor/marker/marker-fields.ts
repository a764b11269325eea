/** Fields of the fabric layout: width, price, edges, allowances, start of the print, nap. */
import {html, nothing, type TemplateResult} from 'lit';

import type {OwnShare} from '../../cutting/allowances.js';
import {
  fabricLimits,
  usualWidths,
  type MarkerChoices,
} from '../../workbench/marker/marker-choices.js';
import type {Units} from '../../model/base/length-text.js';
import type {MarkerTexts} from '../../texts/marker-texts.js';
import type {Format} from '../../texts/format.js';
import type {Texts} from '../../texts/texts.js';
import {lengthField} from '../controls/length-field.js';

interface Fields {
  readonly choices: MarkerChoices;
  /** Start of the print in the displayed marker. [cm] */
  readonly startCm: number | undefined;
  /** True if the user enters a width outside the list. */
  readonly hasOwnWidth: boolean;
  /** True if the fields for allowances are open. */
  readonly hasAllowances: boolean;
  readonly ownAllowances: OwnShare;
  /** True if the print looks different upside down. */
  readonly isOneWay: boolean;
  readonly units: Units;
  readonly format: Format;
  readonly texts: Texts;
  readonly words: MarkerTexts;
  readonly choose: (change: Partial<MarkerChoices>) => void;
  readonly setPrice: (price: number) => void;
  readonly askOwnWidth: () => void;
  readonly askAllowances: () => void;
}

const other = 'other';

const chosen = (event: Event): string => (event.target as HTMLSelectElement).value;

type Length = Exclude<keyof typeof fabricLimits, 'price'>;

/** Steps of the arrow keys other than half a unit. */
const fineSteps: Partial<Record<Length, number>> = {gapCm: 0.1, allowanceCm: 0.1, hemCm: 0.1};

function fabricLength(
  {units, format, texts, choices, choose}: Fields,
  name: Length,
  label: (unit: string) => string,
): TemplateResult {
  return lengthField({
    ...{label, value: choices[name] ?? 0, limits: fabricLimits[name], units, format, texts},
    step: fineSteps[name] ?? 0.5,
    enter: (cm) => {
      choose({[name]: cm});
    },
  });
}

function widthFields(fields: Fields): TemplateResult {
  const {choices, format, words, texts, units, choose, setPrice, hasOwnWidth, askOwnWidth} = fields;
  const isOwn = hasOwnWidth || !usualWidths.includes(choices.widthCm);
  const [least, most] = fabricLimits.price;
  return html`<div class="pair">
      <label>
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
      <sw-number-field
        class="price"
        .label=${words.price[units]}
        .value=${choices.price > 0 ? choices.price : NaN}
        .least=${least}
        .most=${most}
        .step=${0.5}
        .wrong=${texts.controls.between(String(least), String(most))}
        @entered=${({detail}: CustomEvent<number>) => {
          setPrice(detail);
        }}
      ></sw-number-field>
    </div>
    ${isOwn ? fabricLength(fields, 'widthCm', words.widthIn) : nothing}`;
}

/** Cutting sheets use the same allowances. The allowances of the pattern itself take precedence. */
function allowanceFields(fields: Fields): TemplateResult {
  const {choices, format, words, ownAllowances, hasAllowances, askAllowances} = fields;
  if (ownAllowances === 'all')
    return html`<p class="soft allowances">${words.ownAllowances.all}</p>`;
  const said = words.allowances(format.length(choices.allowanceCm), format.length(choices.hemCm));
  return html`<p class="soft allowances">
      ${said}
      <button class="link" aria-expanded=${hasAllowances} @click=${askAllowances}>
        ${words.changeAllowances}
      </button>
      ${ownAllowances === 'some' ? html`<br />${words.ownAllowances.some}` : nothing}
    </p>
    ${
      hasAllowances
        ? html`<div class="pair">
            ${fabricLength(fields, 'allowanceCm', words.allowance)}
            ${fabricLength(fields, 'hemCm', words.hem)}
          </div>`
        : nothing
    }`;
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
    ${isKnown ? fabricLength(fields, 'phaseCm', words.phaseIn) : nothing}`;
}

export function markerFields(fields: Fields): TemplateResult {
  const {choices, words, choose, isOneWay} = fields;
  return html`<div class="fields">
    ${widthFields(fields)}
    <div class="pair">
      ${fabricLength(fields, 'selvedgeCm', words.selvedge)}
      ${fabricLength(fields, 'gapCm', words.gap)}
    </div>
    ${allowanceFields(fields)} ${phaseField(fields)}
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
      <p id="nap" class="soft note">${isOneWay ? words.oneWayPrint : words.oneWayNote}</p>
    </div>
  </div>`;
}
