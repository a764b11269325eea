/** Fields of the fabric as delivered: its shrinkage, and its repeat as measured. */
import {html, nothing, type TemplateResult} from 'lit';

import {fabricOnly, type DesignPrint} from '../../model/design/design.js';
import type {Units} from '../../model/base/length-text.js';
import {shrinkageLimits} from '../../model/print/as-sewn.js';
import type {Delivered} from '../../model/print/repeating-print.js';
import {statedRepeat} from '../../workbench/marker/delivered-print.js';
import type {MarkerTexts} from '../../texts/marker-texts.js';
import type {Format} from '../../texts/format.js';
import type {Texts} from '../../texts/texts.js';
import {lengthField} from '../controls/length-field.js';

interface Fields {
  readonly print: DesignPrint;
  readonly units: Units;
  readonly format: Format;
  readonly texts: Texts;
  readonly words: MarkerTexts;
  readonly isOpen: boolean;
  readonly toggle: () => void;
  readonly choose: (fabric: Delivered) => void;
}

/** A measured repeat is between these multiples of the stated one. */
const measuredRange = [0.81, 1.24] as const;

function shrinkageFields({print, format, texts, words, choose}: Fields): TemplateResult {
  const delivered: Delivered = fabricOnly(print.delivered ?? {});
  const {shrinkage = {warp: 0, weft: 0}} = delivered;
  const [least, most] = shrinkageLimits;
  const field = (way: 'warp' | 'weft'): TemplateResult =>
    html`<sw-number-field
      class=${way}
      .label=${words.shrinkage[way]}
      .value=${shrinkage[way]}
      .least=${least}
      .most=${most}
      .step=${0.5}
      .wrong=${texts.controls.between(format.number(least), format.number(most))}
      @entered=${({detail}: CustomEvent<number>) => {
        choose({...delivered, shrinkage: {...shrinkage, [way]: detail}});
      }}
    ></sw-number-field>`;
  return html`<div class="pair">${field('warp')} ${field('weft')}</div>`;
}

function measuredFields({
  print,
  units,
  format,
  texts,
  words,
  choose,
}: Fields): TemplateResult | typeof nothing {
  const stated = statedRepeat(print);
  if (!stated) return nothing;
  const delivered: Delivered = fabricOnly(print.delivered ?? {});
  const {measured = {}} = delivered;
  const [less, more] = measuredRange;
  const field = (way: 'across' | 'up', own: number): TemplateResult =>
    lengthField({
      ...{name: way, label: words.measured[way], value: measured[way] ?? own, step: 0.1},
      ...{limits: [less * own, more * own], units, format, texts},
      enter: (cm) => {
        choose({...delivered, measured: {...measured, [way]: cm}});
      },
    });
  return html`<div class="pair">
    ${field('across', stated.width)} ${field('up', stated.height)}
  </div>`;
}

/** A line with the values, and the fields below it once they are asked for. */
export function deliveredFields(fields: Fields): TemplateResult {
  const {print, format, words, isOpen, toggle, choose} = fields;
  const {shrinkage, measured} = print.delivered ?? {};
  const said = [
    ...(measured ? [words.measuredAs] : []),
    ...(shrinkage
      ? [words.shrinks(format.number(shrinkage.warp, 2), format.number(shrinkage.weft, 2))]
      : []),
  ];
  return html`<p class="soft delivered">
      ${said.length > 0 ? said.join(' ') : words.asStated}
      <button class="link" aria-expanded=${isOpen} @click=${toggle}>
        ${words.changeDelivered}
      </button>
    </p>
    ${
      isOpen
        ? html`${shrinkageFields(fields)} ${measuredFields(fields)}
            <p class="soft">${words.deliveredNote}</p>
            ${
              print.delivered
                ? html`<p>
                    <button
                      class="link"
                      @click=${() => {
                        choose({});
                      }}
                    >
                      ${words.takeStated}
                    </button>
                  </p>`
                : nothing
            }`
        : nothing
    }`;
}
