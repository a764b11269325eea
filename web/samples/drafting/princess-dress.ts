/**
 * A fitted, sleeveless princess dress: centre front, two side fronts, two side backs, two centre
 * backs. The princess seams absorb the darts of waist and shoulder blade and part of the bust's; a
 * dart from each side seam takes the rest of that. Every panel is its own mirror image or has a
 * partner. With an edge length of 0.53 cm (the option `edgeLengthCm`), the mesh of size M has 16.4
 * thousand triangles.
 */
import type {Body} from './body.js';
import {onBothSides, sew, type Garment} from './panel.js';
import {centreBacks, centreFront, sidePanels} from './princess-panels.js';

/** The parts of a side seam, from the hem up. */
const sideParts = [
  ['skirt', 'below the waist'],
  ['lower', 'below the dart'],
  ['upper', 'above the dart'],
] as const;

/** The parts of a princess seam, from the hem up. */
const parts = [
  ['skirt', 'below the waist'],
  ['waist', 'at the waist'],
  ['top', 'above the bust'],
] as const;

export function draftPrincessDress(body: Body): Garment {
  return {
    name: 'princess-dress',
    title: 'Princess dress',
    panels: [
      centreFront(body),
      ...sidePanels(body, 'front'),
      ...sidePanels(body, 'back'),
      ...centreBacks(body),
    ],
    seams: [
      ...parts.flatMap(([part, where]) =>
        onBothSides(
          'princess',
          `Front princess seam ${where}`,
          ['side_front_*', `princess ${part}`],
          ['centre_front', `princess ${part} *`],
          {notches: [0.5]},
        ),
      ),
      ...onBothSides(
        'dart',
        'Bust dart',
        ['side_front_*', 'dart lower'],
        ['side_front_*', 'dart upper'],
      ),
      ...sideParts.flatMap(([part, where]) =>
        onBothSides(
          'side',
          `Side seam ${where}`,
          ['side_front_*', `side ${part}`],
          ['side_back_*', `side ${part}`],
          {notches: [0.5]},
        ),
      ),
      ...onBothSides(
        'shoulder',
        'Outer shoulder',
        ['side_front_*', 'shoulder'],
        ['side_back_*', 'shoulder'],
      ),
      ...onBothSides(
        'shoulder',
        'Inner shoulder',
        ['centre_front', 'shoulder *'],
        ['centre_back_*', 'shoulder'],
      ),
      ...parts.flatMap(([part, where]) =>
        onBothSides(
          'princess',
          `Back princess seam ${where}`,
          ['side_back_*', `princess ${part}`],
          ['centre_back_*', `princess ${part}`],
          {notches: [0.48, 0.52]},
        ),
      ),
      ...(['top', 'skirt'] as const).map((part) =>
        sew(
          'centre',
          `Centre back ${part === 'top' ? 'above' : 'below'} the waist`,
          ['centre_back_left', `centre ${part}`],
          ['centre_back_right', `centre ${part}`],
          {notches: [0.5]},
        ),
      ),
    ],
    symmetries: [
      ['centre_front'],
      ['side_front_left', 'side_front_right'],
      ['side_back_left', 'side_back_right'],
      ['centre_back_left', 'centre_back_right'],
    ],
  };
}
