/** The pieces of a drawing at one scale, with choices: import or not, and number of cuts. */
import type {PieceChoice} from '../../files/to-garment.js';
import {html, nothing, svg, type TemplateResult} from 'lit';

import type {FileUnit} from '../../model/garment/garment-document.js';
import {readable} from '../../model/garment/piece-names.js';
import type {Units} from '../../model/base/length-text.js';
import type {Format} from '../../texts/format.js';
import type {ImportTexts} from '../../texts/import-texts.js';
import {cmOf, largestOf} from './choices.js';
import type {PieceShape} from './piece-shape.js';
import type {ShownDrawing} from './reading.js';

/** Size of the largest piece, for few and for many pieces. [px] */
const [roomy, dense] = [230, 150];
const many = 9;
/** Same width as in the style. [CSS px] */
const narrow = 768;
/** Margin that keeps lines from being clipped. [px] */
const rim = 2;
/** Lengths of the ruler. [cm] */
const rulers = {cm: 20, inch: 8 * 2.54} as const;

export interface ShownChoices {
  readonly shown: ShownDrawing;
  readonly unit: FileUnit;
  readonly choices: readonly PieceChoice[];
  readonly units: Units;
  readonly words: ImportTexts;
  readonly format: Format;
  readonly choose: (piece: number, change: Partial<PieceChoice>) => void;
}

/** [px / unit of the file] */
function scaleOf(shown: ShownDrawing): number {
  const isRoomy = shown.shapes.length < many && innerWidth >= narrow;
  return (isRoomy ? roomy : dense) / (largestOf(shown, 'cm') || 1);
}

/** @param lines indices of holes that are lines drawn on the piece */
function picture(
  {box, sewn, doubtful, cut, marks, fold}: PieceShape,
  lines: readonly number[],
  scale: number,
): TemplateResult {
  const [left, top, width, height] = box;
  const margin = rim / scale;
  const view = [left - margin, top - margin, width + 2 * margin, height + 2 * margin];
  return html`<svg
    viewBox=${view.join(' ')}
    width=${Math.ceil(width * scale + 2 * rim)}
    height=${Math.ceil(height * scale + 2 * rim)}
    aria-hidden="true"
  >
    ${cut ? svg`<path class="cut" d=${cut}></path>` : nothing}
    <path
      class="sewn"
      d=${[sewn, ...doubtful.flatMap((one) => (lines.includes(one.hole) ? [] : [one.path]))].join('')}
    ></path>
    <path class="marks" d=${marks}></path>
    ${doubtful.map((one) => svg`<path class="doubtful" d=${one.path}></path>`)}
    ${fold ? svg`<path class="fold" d=${fold}></path>` : nothing}
  </svg>`;
}

export function pieceChoice(of: ShownChoices): TemplateResult {
  const {shown, choices, words} = of;
  const scale = scaleOf(shown);
  const all = (take: boolean, title: string): TemplateResult =>
    html`<button
      class="link"
      @click=${() => {
        choices.forEach((_, k) => {
          of.choose(k, {take});
        });
      }}
    >
      ${title}
    </button>`;
  return html`<div class="over">
      <h3 id="pieces">${words.pieces}</h3>
      <span class="soft">${words.toScale}</span>
      ${all(true, words.all)} ${all(false, words.none)}
    </div>
    <ul role="list" aria-labelledby="pieces">
      ${shown.shapes.map((shape, k) => pieceCard(of, shape, k, scale))}
    </ul>`;
}

function pieceCard(of: ShownChoices, shape: PieceShape, k: number, scale: number): TemplateResult {
  const {shown, unit, choices, words, format} = of;
  const piece = shown.drawing.pieces[k];
  const {take = false, cut = 'once', lines = []} = choices[k] ?? {};
  const name = readable(piece?.name ?? '');
  const side = (units: number): string => format.length(units * cmOf(unit));
  const about = [
    words.extent(side(shape.box[2]), side(shape.box[3])),
    ...(piece?.fold ? [words.half] : []),
    ...(piece?.material === undefined ? [] : [piece.material]),
  ];
  return html`<li class=${take ? '' : 'off'}>
    <label>
      <span class="shape">${picture(shape, lines, scale)}</span>
      <span class="name">
        <input
          type="checkbox"
          .checked=${take}
          aria-describedby="about-${k}"
          @change=${({target}: Event) => {
            of.choose(k, {take: (target as HTMLInputElement).checked});
          }}
        />
        <span>${name}</span>
      </span>
    </label>
    <span id="about-${k}" class="soft">${about.join(', ')}</span>
    <select
      aria-label=${words.cut(name)}
      ?disabled=${!take}
      @change=${({target}: Event) => {
        of.choose(k, {cut: (target as HTMLSelectElement).value === 'pair' ? 'pair' : 'once'});
      }}
    >
      <option value="once" ?selected=${cut === 'once'}>${words.once}</option>
      <option value="pair" ?selected=${cut === 'pair'}>${words.pair}</option>
    </select>
    ${shape.doubtful.length === 0 ? nothing : html`<p>${words.holeOrLine}</p>`}
    ${shape.doubtful.map(
      ({hole, size: [width, height]}) =>
        html`<select
          aria-label=${`${words.holeOrLine} ${words.extent(side(width), side(height))}`}
          ?disabled=${!take}
          @change=${({target}: Event) => {
            const others = lines.filter((one) => one !== hole);
            const isLine = (target as HTMLSelectElement).value === 'line';
            of.choose(k, {lines: isLine ? [...others, hole] : others});
          }}
        >
          <option value="hole" ?selected=${!lines.includes(hole)}>
            ${words.hole(words.extent(side(width), side(height)))}
          </option>
          <option value="line" ?selected=${lines.includes(hole)}>
            ${words.lineOn(words.extent(side(width), side(height)))}
          </option>
        </select>`,
    )}
  </li>`;
}

/** Draws a ruler at the scale of the pieces. */
export function ruler({shown, unit, units, words, format}: ShownChoices): TemplateResult {
  const cm = rulers[units];
  const length = (cm / cmOf(unit)) * scaleOf(shown);
  const ticks = Array.from({length: 5}, (_, k) => `M${1 + (k * length) / 4} ${k % 2 ? 5 : 1}V9`);
  return html`<div class="ruler" role="img" aria-label=${words.ruler(format.length(cm))}>
    <svg width=${Math.ceil(length + 2)} height="10" aria-hidden="true">
      <path d="M1 9H${1 + length}${ticks.join('')}"></path>
    </svg>
    <span aria-hidden="true">${format.length(cm)}</span>
  </div>`;
}
