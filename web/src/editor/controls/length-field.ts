/** A field for a length in the user's unit. */
import {html, type TemplateResult} from 'lit';

import type {Units} from '../../model/base/length-text.js';
import type {Format} from '../../texts/format.js';
import type {Texts} from '../../texts/texts.js';
import {lengthUnit} from './number-field.js';

interface LengthField {
  /** Label for a unit: "Fabric width (cm)". */
  readonly label: (unit: string) => string;
  /** [cm] */
  readonly value: number;
  /** Least and greatest length. [cm] */
  readonly limits: readonly [number, number];
  /** Step of the arrow keys, in the user's unit. Default 0.5. */
  readonly step?: number;
  /** Class of the field. */
  readonly name?: string;
  /** A field of another subject drops what was typed. */
  readonly subject?: unknown;
  readonly units: Units;
  readonly format: Format;
  readonly texts: Texts;
  readonly enter: (cm: number) => void;
}

export function lengthField(field: LengthField): TemplateResult {
  const {label, value, limits, step = 0.5, name = '', subject, units, format, texts, enter} = field;
  const [least, most] = limits;
  const {name: unit, cm} = lengthUnit[units];
  return html`<sw-number-field
    class=${name}
    .label=${label(unit)}
    .value=${value / cm}
    .least=${least / cm}
    .most=${most / cm}
    .step=${step}
    .digits=${units === 'inch' ? 3 : 2}
    .fractions=${units === 'inch'}
    .subject=${subject}
    .wrong=${texts.controls.between(format.length(least), format.length(most))}
    @entered=${({detail}: CustomEvent<number>) => {
      enter(detail * cm);
    }}
  ></sw-number-field>`;
}
