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

/** Layers of marks, whose closed lines are no outlines. */
const marks: readonly string[] = [
  ...[turnPoint, curvePoint, gradeReference, mirrorLine, grainLine, drillHole, '9', '10'],
  ...Object.keys(notches),
  ...Object.values(validation),
];

/** Layers of notches and validation copies, which may hold closed lines. */
const closedMarks: readonly string[] = [...Object.keys(notches), ...Object.values(validation)];

/** Returns whether closed lines of a layer are marks. Other layers of marks hold none. */
export const holdsClosedMarks = (layer: string): boolean => closedMarks.includes(layer);

export const isMark = (layer: string): boolean => marks.includes(layer);

/** The roles of closed lines by their layers. */
export const roles: Readonly<Record<string, 'sewn line' | 'cut-out' | 'mark'>> = {
  [sewLine]: 'sewn line',
  [cutOut]: 'cut-out',
  [internalLine]: 'mark',
};
