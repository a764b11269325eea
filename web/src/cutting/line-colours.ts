/** Colours of lines by layer, by which cutting and plotting programs tell them apart. */
import type {CutLayer} from './cut-sheet.js';

interface LineColour {
  /** sRGB. */
  readonly hex: string;
  /** AutoCAD colour index, for DXF. */
  readonly index: number;
}

const ink: LineColour = {hex: '#1d1f23', index: 7};

export const lineColours: Readonly<Record<CutLayer, LineColour>> = {
  ...{print: ink, marks: ink, words: ink},
  cut: {hex: '#c8161d', index: 1},
  sew: {hex: '#1450b4', index: 5},
  matches: {hex: '#0a6b45', index: 3},
};
