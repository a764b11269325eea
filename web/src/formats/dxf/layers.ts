/** Layers of AAMA-292 and ASTM D6673. */
import type {NotchKind} from '../../model/garment/imported-drawing.js';

export const boundary = '1';
export const turnPoint = '2';
export const curvePoint = '3';
export const gradeReference = '5';
export const mirrorLine = '6';
export const grainLine = '7';
export const internalLine = '8';
export const cutOut = '11';
export const drillHole = '13';
export const sewLine = '14';
/** Layers on which Valentina writes piece names. */
export const annotations: readonly string[] = ['15', '19'];
/** Validation layers with dense points, by the layer they copy. */
export const validation: Readonly<Record<string, string>> = {1: '84', 8: '85', 11: '86', 14: '87'};

export const notches: Readonly<Record<string, NotchKind>> = {
  4: 'v',
  80: 't',
  81: 'castle',
  82: 'check',
  83: 'u',
};
