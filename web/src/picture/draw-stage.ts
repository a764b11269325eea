/**
 * Draws one stage of a solve for debugging: meshes, cells of the print on the pieces, and seam
 * letters.
 */
import type {Alignment} from '../model/geometry/vectors.js';
import type {Pattern} from '../model/result/result.js';
import {clothTile} from './cloth.js';
import {drawPieces, type Scene} from './draw-pieces.js';
import {mismatchOf} from '../scene/mismatch.js';
import {laidOut, margin, nameSize, width} from './page.js';
import {escaped, short, text} from './svg.js';

export interface Stage {
  readonly title: string;
  readonly pattern: Pattern;
  readonly outline: Scene['outline'];
  readonly alignments: readonly Alignment[];
}

const top = 76;

/** The stage as SVG text. Pieces have the names of their panel keys, as in files and messages. */
export function drawStage({title, pattern, outline, alignments}: Stage): string {
  const names = pattern.pieces.map(({name}) => name);
  const {layout, scale} = laidOut(pattern, names, undefined);
  const height = top + layout.height * scale + margin;
  const mismatch = mismatchOf(pattern, outline, alignments);
  const {group, w1, w2} = pattern.print;
  const print = {group, w1, w2};
  const scene: Scene = {
    ...{result: pattern, print, outline, alignments, mismatch, layout, names, scale},
    ...{id: 'stage', cloth: 'stage-cloth', isBare: false, hasMesh: true},
    corner: [(width - layout.width * scale) / 2, top],
  };
  const note = `${group}; mean mismatch ${(10 * mismatch.mean).toFixed(2)} mm, fit ${mismatch.total.toFixed(3)} cm²`;
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${short(height)}" viewBox="0 0 ${width} ${short(height)}" font-family="sans-serif">`,
    `<title>${escaped(title)}</title>`,
    `<defs>${clothTile('stage-cloth', print, scale)}</defs>`,
    '<rect width="100%" height="100%" fill="#fff"/>',
    text([margin, 34], title, {size: 20, weight: 600}),
    text([margin, 56], note, {size: 13}),
    drawPieces(scene, nameSize),
    '</svg>\n',
  ].join('\n');
}
