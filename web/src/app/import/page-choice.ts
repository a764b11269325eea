/** The pages of a PDF as they are put together, and the choices that change it. */
import {html, nothing, svg, type TemplateResult} from 'lit';

import {lengthUnit} from '../../editor/controls/number-field.js';
import type {AssembledPages, DrawingOptions} from '../../model/garment/imported-drawing.js';
import type {Point} from '../../model/geometry/vectors.js';
import {numbersIn, rangesOf} from '../../model/base/number-ranges.js';
import type {Units} from '../../model/base/length-text.js';
import type {Format} from '../../texts/format.js';
import type {ImportTexts} from '../../texts/import-texts.js';
import type {Texts} from '../../texts/texts.js';
import {dragPage} from './page-drag.js';
import {addedPage, cellAt, movedPage, placesOf} from './page-places.js';
import type {ShownDrawing} from './reading.js';

/** Greatest trim, overlap and allowance. [cm] */
const widest = 10;
const mostColumns = 60;

export interface ShownPages {
  readonly shown: ShownDrawing;
  readonly pages: AssembledPages;
  readonly options: DrawingOptions;
  readonly units: Units;
  readonly words: ImportTexts;
  readonly texts: Texts;
  readonly format: Format;
  /** Puts the pages together with other options. */
  readonly choose: (change: DrawingOptions) => void;
}

/** The pages of the file that are not on the sheet. */
function unused({placed, count}: AssembledPages): readonly number[] {
  const used = new Set(placed.map(({number}) => number));
  return Array.from({length: count}, (_, k) => k + 1).filter((number) => !used.has(number));
}

const usedIn = ({placed}: AssembledPages): readonly number[] => placed.map(({number}) => number);

/** Fields for page numbers, columns, trim and overlap. */
export function pageChoice(of: ShownPages): TemplateResult {
  const {pages, words} = of;
  const others = unused(pages);
  return html`<section>
    <h3>${words.pages}</h3>
    ${numbersField(of)} ${pages.placed.length > 1 ? gridFields(of) : nothing}
    ${
      others.length > 0
        ? html`<p class="soft">${words.leftOut(rangesOf(others))}</p>
            ${takeBack(of, others)}`
        : nothing
    }
  </section>`;
}

/** Greatest number of buttons for pages that are left out. */
const mostButtons = 12;

/** Buttons that put pages onto the sheet again. */
function takeBack(
  {pages, options, words, choose}: ShownPages,
  others: readonly number[],
): TemplateResult {
  const add = (number: number): void => {
    const {without = []} = options;
    if (without.includes(number)) choose({without: without.filter((one) => one !== number)});
    else choose({places: addedPage(placesOf(pages), number)});
  };
  return html`<div class="back">
    ${others.slice(0, mostButtons).map(
      (number) =>
        html`<button
          class="outlined"
          aria-label=${words.takeBack(number)}
          title=${words.takeBack(number)}
          @click=${() => {
            add(number);
          }}
        >
          + ${number}
        </button>`,
    )}
  </div>`;
}

function numbersField({pages, words, choose}: ShownPages): TemplateResult {
  const used = rangesOf(usedIn(pages));
  return html`<label>
    ${words.pageNumbers}
    <input
      type="text"
      inputmode="numeric"
      autocomplete="off"
      .value=${used}
      @change=${({target}: Event) => {
        const field = target as HTMLInputElement;
        const numbers = numbersIn(field.value)?.filter((number) => number <= pages.count);
        if (numbers && numbers.length > 0) choose({pages: numbers, without: []});
        else field.value = used;
      }}
    />
  </label>`;
}

function gridFields(of: ShownPages): TemplateResult {
  const {pages, texts, words, choose} = of;
  const count = pages.placed.length;
  const most = Math.min(mostColumns, count);
  return html`<div class="grid">
    <sw-number-field
      .label=${words.columns}
      .value=${pages.columns}
      .least=${1}
      .most=${most}
      .step=${1}
      .digits=${0}
      .wrong=${texts.controls.between('1', String(most))}
      @entered=${({detail}: CustomEvent<number>) => {
        const columns = Math.round(detail);
        choose({pages: usedIn(pages), without: [], grid: [columns, Math.ceil(count / columns)]});
      }}
    ></sw-number-field>
    ${lengthField(of, 'trimCm', words.trim, pages.trimCm ?? 0)}
    ${lengthField(of, 'overlapCm', words.overlap, pages.overlapCm?.[0] ?? 0)}
  </div>`;
}

function lengthField(
  {texts, format, units, options, choose}: ShownPages,
  name: 'trimCm' | 'overlapCm' | 'allowanceCm',
  label: (unit: string) => string,
  found: number,
): TemplateResult {
  const {cm, name: unit} = lengthUnit[units];
  return html`<sw-number-field
    .label=${label(unit)}
    .value=${Number(((options[name] ?? found) / cm).toFixed(2))}
    .least=${0}
    .most=${widest / cm}
    .step=${0.1}
    .fractions=${units === 'inch'}
    .digits=${3}
    .wrong=${texts.controls.between(format.length(0), format.length(widest))}
    @entered=${({detail}: CustomEvent<number>) => {
      choose({[name]: detail * cm});
    }}
  ></sw-number-field>`;
}

/** The seam allowance that the lines include; asked unless the file draws both lines. */
export function allowanceChoice(of: ShownPages): TemplateResult | typeof nothing {
  const {shown, options, words} = of;
  const {pieces} = shown.drawing;
  const isKnown = options.allowanceCm === undefined && pieces.every(({cut}) => cut);
  if (isKnown || pieces.length === 0) return nothing;
  const isAsked = options.allowanceCm === undefined;
  return html`<section class=${isAsked ? 'doubtful' : nothing}>
    <h3>${words.included}</h3>
    ${lengthField(of, 'allowanceCm', words.allowance, 0)}
    <p class="soft">${words.allowanceNote}</p>
  </section>`;
}

const short = (value: number): string => String(Number(value.toFixed(1)));

/** Margin around the sheet, as a share of its longer side. */
const rim = 0.01;

/** Draws the sheet with its pages, which are dragged to other places; a click leaves a page out. */
export function pagePreview({pages, shown, options, words, choose}: ShownPages): TemplateResult {
  const {placed, openJoints} = pages;
  const corners = placed.flatMap(({low, high}) => [low, high]);
  const side = (axis: 0 | 1, most: boolean): number =>
    (most ? Math.max : Math.min)(...corners.map((corner) => corner[axis]));
  const [left, right, low, high] = [side(0, false), side(0, true), side(1, false), side(1, true)];
  const margin = rim * Math.max(right - left, high - low);
  const view = [left - margin, -high - margin, right - left + 2 * margin, high - low + 2 * margin];
  const leaveOut = (number: number): void => {
    if (placed.length > 1) choose({without: [...(options.without ?? []), number]});
  };
  return html`<svg
    class="sheet"
    viewBox=${view.map(short).join(' ')}
    role="img"
    aria-label=${words.sheet}
  >
    ${placed.map(
      ({number, low: corner, high: top}) =>
        svg`<g class="page" @pointerdown=${(event: PointerEvent) => {
          dragPage(event, {
            onClick: () => {
              leaveOut(number);
            },
            onDrop: (at) => {
              const places = movedPage(placesOf(pages), number, cellAt(pages, at));
              choose({places, without: []});
            },
          });
        }}>
          <title>${words.leaveOut(number)}</title>
          <rect x=${short(corner[0])} y=${short(-top[1])}
            width=${short(top[0] - corner[0])} height=${short(top[1] - corner[1])}></rect>
          ${placed.length > 1 ? pageNumber(number, corner, top) : nothing}
        </g>`,
    )}
    <path class="sewn" d=${shown.shapes.map(({sewn}) => sewn).join('')}></path>
    <path class="cut" d=${shown.shapes.map(({cut}) => cut).join('')}></path>
    <path
      class="open"
      d=${openJoints.map((joint) => jointPath(joint.pages, pages)).join('')}
    ></path>
  </svg>`;
}

function pageNumber(number: number, low: Point, high: Point): TemplateResult {
  const size = 0.16 * Math.min(high[0] - low[0], high[1] - low[1]);
  return svg`<text x=${short(low[0] + size / 2)} y=${short(-high[1] + 1.2 * size)}
    font-size=${short(size)}>${number}</text>`;
}

/** The common side of two pages. */
function jointPath([a, b]: readonly [number, number], {placed}: AssembledPages): string {
  const [one, two] = [a, b].map((number) => placed.find((page) => page.number === number));
  if (!one || !two) return '';
  const isBeside = one.cell?.[1] === two.cell?.[1];
  return isBeside
    ? `M${short(one.high[0])} ${short(-one.high[1])}V${short(-one.low[1])}`
    : `M${short(one.low[0])} ${short(-one.low[1])}H${short(one.high[0])}`;
}
