/** The tailored prints of the collection: plaids, stripes and a foulard. */
import {place, rhombicLevel, tailored, type Colourways, type Design} from './design.js';
import {drawPlaid, drawStripe, even, plaidCell, sett, stripeCell, type Sett} from './plaid.js';
import {leaf, stem, willow} from './plants.js';
import {dart} from './geometric.js';
import {dot, grown, together, type Motif} from './shape.js';

function plaid(id: string, title: string, colourways: Colourways, warp: Sett, weft: Sett): Design {
  const draw = drawPlaid(warp, weft);
  return {id, title, family: 'tailored', cell: plaidCell(warp, weft), colourways, draw};
}

function stripe(id: string, title: string, colourways: Colourways, warp: Sett): Design {
  const draw = drawStripe(warp);
  return {id, title, family: 'tailored', cell: stripeCell(warp), colourways, draw};
}

const tartan = even('leaf 3 ground 0.5 line 0.25 ground 2.5 bloom 0.75 ground 1.25 leaf 0.25');

/** A quarter of a medallion, 5 cm wide and 6 cm high. */
const medallion: Motif = together(
  grown(leaf('leaf', 3), [0.12, 0.5], -16, 2.5),
  grown(leaf('leaf', 2), [0.5, 0.3], -52, 1.9),
  grown(willow('bloom'), [0.6, 0.05], -84, 2.1),
  [dot('spark', [0, 0], 0.26)],
);

/**
 * Half of a garland's side: a half turn about its foot continues it, and so does a mirror at its
 * tip.
 */
const garland: Motif = [
  ...stem(
    '0,0 0.2,0.7 0.1,1.6 0,2.9',
    [0.1, 0.1],
    [willow('line'), 0.28, 48, 1.15],
    [willow('line'), 0.5, -44, 1.1],
    [willow('line'), 0.72, 44, 0.9],
  ),
  dot('spark', [0, 0], 0.2),
];

export const tailoredPrints: readonly Design[] = [
  tailored('cmm', 'Foulard', ['celadon', 'blush', 'night'], 'cmm', rhombicLevel(10, 14), [
    place(medallion, 0, 0),
    place(dart('bloom'), 5, 0, -20, 1.6),
    place(leaf('leaf', 2), 5, 0, -64, 1.5),
    place(garland, 2.5, 3.5, 60.7),
  ]),
  plaid('tartan', 'Tartan', ['moss', 'linen', 'mist'], tartan, tartan),
  plaid(
    'check',
    'Shirting check',
    ['smoke', 'linen', 'blush'],
    even('leaf 1.5 ground 1.25 line 0.25 ground 1.25 soft 2'),
    even('leaf 1.5 ground 1.75 bloom 0.25 ground 1.75 soft 2.5'),
  ),
  plaid(
    'plaid',
    'Uneven plaid',
    ['plum', 'clay', 'mist'],
    sett('ground 2 leaf 2 soft 1 line 0.5 ground 1 bloom 0.5'),
    sett('ground 2 bloom 1.5 soft 1.5 line 0.5 ground 1.5 spark 0.25 leaf 1'),
  ),
  stripe(
    'ticking',
    'Ticking',
    ['linen', 'mist', 'night'],
    even('line 0.75 ground 0.25 line 0.125 ground 2 bloom 0.25 ground 0.25 bloom 0.5'),
  ),
  stripe(
    'regatta',
    'Regatta',
    ['mist', 'clay', 'plum'],
    sett('line 1.5 ground 0.5 leaf 1 ground 0.25 soft 2 bloom 0.5 ground 2'),
  ),
];
