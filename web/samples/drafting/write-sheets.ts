/** Writes docs/garments.svg: every garment of the wardrobe, flat, in size M. */
import {writeFileSync} from 'node:fs';
import {bodyOf} from './body.js';
import {garmentSheet} from './sheet.js';
import {wardrobe} from './wardrobe.js';

const garments = wardrobe.map((draft) => draft(bodyOf('m')));
writeFileSync(
  'docs/garments.svg',
  garmentSheet(
    garments,
    'Sample garments',
    'Size M, without seam allowance. Edges with the same number are sewn together; strokes into a piece are notches, ticks outside it part its edges, arrows the grain, dashed lines lie on each other.',
  ),
);
