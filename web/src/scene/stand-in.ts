/** A scene for a stored drape, until the solver has read the garment. */
import type {Alignment} from '../model/geometry/vectors.js';
import type {Print} from '../model/print/repeating-print.js';
import type {PatternScene} from './scene.js';

/**
 * Returns a scene of pieces without points, which are not drawn flat.
 * @param names names of the pieces
 * @param alignments one for each piece
 */
export const standInScene = (
  names: readonly string[],
  alignments: readonly Alignment[],
  print: Print,
): PatternScene => ({
  pattern: {
    print: {group: print.group, w1: print.w1, w2: print.w2},
    continuousOnly: false,
    pieces: [],
    seams: [],
    symmetries: [],
  },
  outline: 'shape',
  print,
  pieces: names.map((name, k) => ({
    ...{name, label: name, plain: false, offset: [0, 0], points: []},
    ...{triangles: [], outline: [], holes: []},
    alignment: alignments[k] ?? {angle: 0, translation: [0, 0]},
  })),
  seams: [],
  symmetries: [],
  size: [0, 0],
  scale: 'absolute',
});
