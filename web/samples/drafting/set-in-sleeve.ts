/** Sleeves that are set into a closed armhole: their outline and seams. */
import type {Half} from './bodice.js';
import {edge, onBothSides, type Edge, type EdgeName, type Seam} from './panel.js';
import type {Cap, Tube} from './sleeve.js';

/** The outline from the lower edge, which is called `hem`, up the back and down the front. */
export const setInOutline = (cap: Cap, tube: Tube, hem = 'hem'): Edge[] => [
  edge(hem, tube.hem),
  edge('underarm back', tube.underarmBack),
  edge('cap back', cap.back),
  edge('cap front', cap.front),
  edge('underarm front', tube.underarmFront),
];

/**
 * The seams of a cap. The crown, where its halves meet, is marked, as it meets the shoulder seam.
 * @param ease  of the cap over either half of the armhole, in cm
 */
export const setInSeams = (
  ease: Readonly<Record<Half, number>>,
  armholes: Readonly<Record<Half, EdgeName>>,
): Seam[] => [
  ...onBothSides('armhole', 'Front armhole', ['sleeve_*', 'cap front'], armholes.front, {
    ease: ease.front,
    notches: [0.55],
    ownNotches: [0],
  }),
  ...onBothSides('armhole', 'Back armhole', ['sleeve_*', 'cap back'], armholes.back, {
    ease: ease.back,
    notches: [0.42, 0.47],
  }),
  ...onBothSides(
    'underarm',
    'Underarm',
    ['sleeve_*', 'underarm front'],
    ['sleeve_*', 'underarm back'],
  ),
];
