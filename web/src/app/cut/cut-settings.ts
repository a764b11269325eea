/** Controls of the cutting dialog: file, paper, allowances, print and placing guide. */
import {html, nothing, type TemplateResult} from 'lit';

import {lengthUnit} from '../../editor/controls/number-field.js';
import {greatestAllowance} from '../../cutting/allowance-rule.js';
import {printInks} from '../../cutting/print-ink.js';
import {dxfStyles, dxfUnits, type DxfStyle, type DxfUnit} from '../../model/base/dxf-format.js';
import type {Units} from '../../model/base/length-text.js';
import {paperOf} from '../../paper/papers.js';
import type {CutTexts} from '../../texts/cut-texts.js';
import type {Format} from '../../texts/format.js';
import type {Texts} from '../../texts/texts.js';
import {cutFileKinds, papers, type CutChoices} from './cut-choices.js';
import type {CutPlan} from './cut-job.js';

/** The settings, and what their controls need. */
interface Shown {
  readonly choices: CutChoices;
  /** Undefined until there is one. */
  readonly plan: CutPlan | undefined;
  readonly words: CutTexts;
  readonly texts: Texts;
  readonly format: Format;
  readonly units: Units;
  readonly choose: (change: Partial<CutChoices>) => void;
}

function filePart({choices, words, choose}: Shown): TemplateResult {
  return html`<div class="file">
    <h3 id="file">${words.file}</h3>
    <div class="files" role="group" aria-labelledby="file" aria-describedby="for">
      ${cutFileKinds.map(
        (file) =>
          html`<button
            class="outlined"
            aria-pressed=${file === choices.file}
            @click=${() => {
              choose({file});
            }}
          >
            ${words.files[file]}
          </button>`,
      )}
    </div>
    <p id="for" class="soft">${words.fileNotes[choices.file]}</p>
  </div>`;
}

/** Dialect and unit of a DXF file. */
function dxfPart({choices: {dxfStyle, dxfUnit}, words, choose}: Shown): TemplateResult {
  return html`<label>
      ${words.dxfStyle}
      <select
        @change=${({target}: Event) => {
          choose({dxfStyle: (target as HTMLSelectElement).value as DxfStyle});
        }}
      >
        ${dxfStyles.map(
          (style) =>
            html`<option value=${style} ?selected=${style === dxfStyle}>
              ${words.dxfStyles[style]}
            </option>`,
        )}
      </select>
    </label>
    <label>
      ${words.dxfUnit}
      <select
        @change=${({target}: Event) => {
          choose({dxfUnit: (target as HTMLSelectElement).value as DxfUnit});
        }}
      >
        ${dxfUnits.map(
          (unit) =>
            html`<option value=${unit} ?selected=${unit === dxfUnit}>
              ${words.dxfUnits[unit]}
            </option>`,
        )}
      </select>
    </label>`;
}

function paperPart(shown: Shown): TemplateResult {
  const {choices, words, choose} = shown;
  return html`<label>
    ${words.paper}
    <select
      @change=${({target}: Event) => {
        choose({paper: (target as HTMLSelectElement).value});
      }}
    >
      ${papers.map(
        (paper) =>
          html`<option value=${paper} ?selected=${paper === choices.paper}>
            ${called(paper, shown)}
          </option>`,
      )}
    </select>
  </label>`;
}

/** Returns the paper's name with its size, if it has one. */
function called(paper: string, {words, format}: Shown): string {
  if (paper === 'projector') return words.projector;
  const {name = '', widthCm = 0, heightCm} = paperOf(paper) ?? {};
  if (heightCm === undefined) return words.roll;
  return words.each(name, words.extent(format.length(widthCm), format.length(heightCm)));
}

function lengthPart(
  name: 'allowanceCm' | 'hemCm',
  label: (unit: string) => string,
  {choices, format, texts, units, choose}: Shown,
): TemplateResult {
  const {cm, name: unit} = lengthUnit[units];
  return html`<sw-number-field
    .label=${label(unit)}
    .value=${choices[name] / cm}
    .least=${0}
    .most=${greatestAllowance / cm}
    .step=${0.1}
    .fractions=${units === 'inch'}
    .digits=${3}
    .wrong=${texts.controls.between(format.length(0), format.length(greatestAllowance))}
    @entered=${({detail}: CustomEvent<number>) => {
      choose({[name]: detail * cm});
    }}
  ></sw-number-field>`;
}

/** Note that pieces with their own allowances ignore the fields. */
function ownPart({plan, words}: Shown): TemplateResult | typeof nothing {
  const {ownAllowances = 'none'} = plan ?? {};
  if (ownAllowances === 'none') return nothing;
  return html`<p class="soft" role="status">${words.ownAllowances[ownAllowances]}</p>`;
}

/** Choice of the print's strength; cutters and plotters accept lines only. */
function inkPart({choices, words, choose}: Shown): TemplateResult | typeof nothing {
  if (choices.file === 'dxf' || choices.file === 'plt') return nothing;
  return html`<div class="file">
    <h3 id="ink">${words.ink}</h3>
    <div class="inks" role="group" aria-labelledby="ink">
      ${printInks.map(
        (ink) =>
          html`<button
            class="outlined"
            aria-pressed=${ink === choices.ink}
            @click=${() => {
              choose({ink});
            }}
          >
            ${words.inks[ink]}
          </button>`,
      )}
    </div>
  </div>`;
}

/** Checkbox for a placing guide; a projector shows the print in place. */
function guidePart({choices, words, choose}: Shown): TemplateResult | typeof nothing {
  if (choices.file !== 'pdf' || choices.paper === 'projector') return nothing;
  return html`<div class="file">
    <label class="inline">
      <input
        type="checkbox"
        aria-describedby="guide"
        .checked=${choices.guide}
        @change=${({target}: Event) => {
          choose({guide: (target as HTMLInputElement).checked});
        }}
      />
      ${words.guide}
    </label>
    <p id="guide" class="soft">${words.guideNote}</p>
  </div>`;
}

export const cutSettings = (shown: Shown): TemplateResult =>
  html`${filePart(shown)} ${shown.choices.file === 'pdf' ? paperPart(shown) : nothing}
    ${shown.choices.file === 'dxf' ? dxfPart(shown) : nothing}
    <div class="lengths">
      ${lengthPart('allowanceCm', shown.words.allowance, shown)}
      ${lengthPart('hemCm', shown.words.hem, shown)} ${ownPart(shown)}
    </div>
    ${inkPart(shown)} ${guidePart(shown)}`;
