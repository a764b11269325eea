/**
 * A bib apron: skirt and bib on a waistband that continues as the ties, a strap around the neck,
 * and a patch pocket, which is stitched onto the skirt instead of edge to edge. Every piece is its
 * own mirror image.
 */
import {plus, radians, type Point} from '../../src/model/geometry/vectors.js';
import {radiusOf, type Body} from './body.js';
import {curve, leaning, line, mirror, mirrored, pointAt, reversed, type Curve} from './curves.js';
import {
  edge,
  onBothSides,
  sew,
  symmetricPanel,
  turnsOnBothSides,
  type Garment,
  type Panel,
  type Placement,
} from './panel.js';

const bandHeight = 4.5;
const tieLength = 85;
const strapWidth = 3.5;
const skirt = {length: 52, lean: radians(8), corner: 9};
const pocket = {width: 26, height: 17, corner: 5, belowWaist: 13};

/** Half widths and heights that follow from the body. [cm] */
function widths(body: Body): {bibTop: number; bibBottom: number; bibHeight: number; skirt: number} {
  return {
    bibTop: 0.125 * body.bust,
    bibBottom: 0.2 * body.waist,
    bibHeight: 0.66 * body.backLength,
    skirt: 0.36 * body.waist,
  };
}

function inFront(body: Body, height: number, away: number): Placement {
  return {
    translation: [0, body.waistHeight + height, radiusOf(body.hip) + away],
    rotation: [0, 0, 0],
  };
}

/**
 * The quarter turn from a level line that ends at `from` to a line that leaves along `into`; fair
 * rather than circular.
 */
const roundCorner = (from: Point, to: Point, into: Point, size: number): Curve =>
  curve(from, [1, 0], to, into, 0.55 * size, 0.55 * size);

/** Origin: the middle of the waist. */
function skirtPanel(body: Body): Panel {
  const waist: Point = [widths(body).skirt, 0];
  const up = leaning(-skirt.lean);
  const foot = plus(waist, up, -skirt.length / Math.cos(skirt.lean));
  const low: Point = [foot[0] - skirt.corner, foot[1]];
  const high = plus(foot, up, skirt.corner);
  return symmetricPanel(
    'skirt',
    {
      bottom: edge('hem', line(mirror(low), low)),
      half: [
        edge('corner', roundCorner(low, high, up, skirt.corner)),
        edge('side', line(high, waist)),
      ],
      top: edge('waist', line(waist, mirror(waist))),
      side: 'left',
    },
    inFront(body, -bandHeight, 8),
  );
}

/** Origin: the middle of the waist. */
function bibPanel(body: Body): Panel {
  const {bibTop, bibBottom, bibHeight} = widths(body);
  const waist: Point = [bibBottom, 0];
  const top: Point = [bibTop, bibHeight];
  const inner: Point = [bibTop - strapWidth, bibHeight];
  return symmetricPanel(
    'bib',
    {
      bottom: edge('waist', line(mirror(waist), waist)),
      half: [
        edge('side', curve(waist, leaning(radians(-18)), top, [0, 1])),
        edge('strap', line(top, inner)),
      ],
      top: edge('upper', line(inner, mirror(inner))),
      side: 'left',
    },
    inFront(body, 0, 8),
  );
}

/** Waistband and ties in one. Origin: the middle of the lower edge. */
function bandPanel(body: Body): Panel {
  const {skirt: half, bibBottom} = widths(body);
  const end = half + tieLength;
  const [low, high]: [Point, Point] = [
    [half, 0],
    [bibBottom, bandHeight],
  ];
  return symmetricPanel(
    'waistband',
    {
      bottom: edge('skirt', line(mirror(low), low)),
      half: [
        edge('tie lower', line(low, [end, 0])),
        edge('tie end', line([end, 0], [end, bandHeight])),
        edge('tie upper', line([end, bandHeight], high)),
      ],
      top: edge('bib', line(high, mirror(high))),
      side: 'left',
    },
    inFront(body, -bandHeight, 10),
  );
}

/**
 * The strap behind the neck, seen from behind; its grain continues upwards from the bib. Origin:
 * the middle of the lower edge.
 */
function strapPanel(body: Body): Panel {
  const rise = body.backLength + 3 - widths(body).bibHeight;
  const half = rise + body.neck / 4 + 4;
  const [low, high]: [Point, Point] = [
    [half, 0],
    [half, strapWidth],
  ];
  return {
    ...symmetricPanel(
      'neck_strap',
      {
        bottom: edge('lower', line(mirror(low), low)),
        half: [edge('end', line(low, high))],
        top: edge('upper', line(high, mirror(high))),
        side: 'right',
      },
      {
        translation: [0, body.waistHeight + body.backLength, -radiusOf(body.neck) - 8],
        rotation: [0, 180, 0],
      },
    ),
    grain: [1, 0],
  };
}

/**
 * Sides and bottom of the pocket's half, from the middle of the bottom. Origin: the middle of the
 * opening.
 */
function pocketHalf(): {readonly corner: Curve; readonly side: Curve} {
  const {width, height, corner} = pocket;
  const out = width / 2;
  return {
    corner: roundCorner([out - corner, -height], [out, corner - height], [0, 1], corner),
    side: line([out, corner - height], [out, 0]),
  };
}

function pocketPanel(body: Body): Panel {
  const {corner, side} = pocketHalf();
  return symmetricPanel(
    'pocket',
    {
      bottom: edge('bottom', line(mirror(corner.from), corner.from)),
      half: [edge('corner', corner), edge('side', side)],
      top: edge('opening', line(side.to, mirror(side.to))),
      side: 'left',
    },
    inFront(body, -bandHeight - pocket.belowWaist, 9),
  );
}

/** The stitching line of the pocket, from opening to opening, if its origin is at `at`. */
function stitchedDown(at: Point): Point[] {
  const {corner, side} = pocketHalf();
  const half = [...Array.from({length: 5}, (_, k) => pointAt(corner, k / 4)), side.to];
  const other = [...Array.from({length: 5}, (_, k) => pointAt(reversed(mirrored(corner)), k / 4))];
  return [mirror(side.to), ...other, ...half].map((p) => plus(p, at));
}

export function draftApron(body: Body): Garment {
  return {
    name: 'apron',
    title: 'Apron',
    panels: [
      skirtPanel(body),
      bandPanel(body),
      bibPanel(body),
      strapPanel(body),
      pocketPanel(body),
    ],
    seams: [
      sew('waist', 'Skirt waist', ['skirt', 'waist'], ['waistband', 'skirt'], {notches: [0.5]}),
      sew('waist', 'Bib waist', ['bib', 'waist'], ['waistband', 'bib'], {notches: [0.5]}),
      ...onBothSides('shoulder', 'Neck strap', ['bib', 'strap *'], ['neck_strap', 'end *']),
    ],
    matches: [
      {
        name: 'Pocket',
        a: {panel: 'skirt', line: stitchedDown([0, -pocket.belowWaist])},
        b: {panel: 'pocket', line: stitchedDown([0, 0])},
      },
    ],
    turns: [
      ...turnsOnBothSides(['skirt', 'side *', 'waist'], 'the tie goes on beyond the skirt'),
      ...turnsOnBothSides(['bib', 'side *', 'waist'], 'the tie goes on beyond the bib'),
      ...turnsOnBothSides(
        ['bib', 'strap *', 'upper'],
        'the strap goes up from the edge of the bib',
      ),
    ],
    symmetries: [['skirt'], ['waistband'], ['bib'], ['neck_strap'], ['pocket']],
  };
}
