/**
 * A fitted dress whose front is parted by a diagonal seam, from under the bust at the wearer's right down to the hip
 * at the left: two front pieces without any symmetry, a back that is its own mirror image, and a pair of side panels
 * instead of side seams. The panel seams run into the armholes. The height of the waist is y = 0 throughout.
 */
import {hung, roundNeckline, type Half} from './bodice.js';
import {radiusOf, type Body} from './body.js';
import {bodiceSeam, skirtSeam, upright} from './fitted-seams.js';
import {
  curve,
  degrees,
  leaning,
  left,
  length,
  line,
  mirrored,
  moved,
  plus,
  reversed,
  splitAtLengths,
  trueTo,
  turned,
  type Curve,
  type Point,
} from './geometry.js';
import {
  edge,
  onBothSides,
  pairOf,
  sew,
  symmetricPanel,
  type Edge,
  type Garment,
  type Panel,
  type Seam,
} from './panel.js';
import {heading, squareBelow} from './skirt-lines.js';

const ease = {bust: 6, waist: 6, hip: 6};
const skirtLength = 54;
/** How much further than the hip the hem stands out at each panel seam. */
const flare = degrees(1.2);
const shoulderSlope = degrees(19);
const shoulderLength = 9;
const neckDepth = {front: 10, back: 3};
/** From the nape down to the underarm, beyond a tenth of the bust. */
const armholeDepth = 11.5;
/** Where the diagonal ends: below the bust at the right and below the waist at the left, along the panel seam. */
const diagonal = {belowBust: 8, belowWaist: 15};
/** How far the diagonal bends away from straight at its ends. */
const bend = degrees(9);

/** How the panel seam of a half runs, and where it meets the armhole. [cm, radians] */
const shapes = {
  front: {
    /** x of the seam, as a part of the waist; what it goes out by up to the bust; how high that is. */
    waist: 0.115,
    out: 1.7,
    bust: 0.41,
    /** Where the armhole is met: in from the shoulder point and up from the underarm; how the armhole leans in there. */
    inward: 3,
    up: 6.5,
    lean: degrees(13),
    /** The side panel's edge: what it goes out by up to the bust, and comes back by up to the armhole. */
    sideOut: 2,
    sideBack: 6.5,
  },
  back: {
    waist: 0.11,
    out: 1.6,
    bust: 0.45,
    inward: 2.4,
    up: 7.5,
    lean: degrees(9),
    sideOut: 1.8,
    sideBack: 5.5,
  },
} as const;

/** The edges of a panel seam from the hem up: hem to waist, waist to the height of the bust, on to the armhole. */
interface PanelSeam {
  readonly skirt: Curve;
  readonly bodice: Curve;
  readonly top: Curve;
}

const underarmHeight = (body: Body): number => body.backLength - (body.bust / 10 + armholeDepth);
const neckPoint = (body: Body): Point => [body.neck / 5 + 2.2, body.backLength + 1.8];
const shoulderTip = (body: Body): Point =>
  plus(neckPoint(body), [Math.cos(shoulderSlope), -Math.sin(shoulderSlope)], shoulderLength);

/** What every edge leans out by below the waist so that all eight make the hip. */
function hipLean(body: Body): number {
  const wider = body.hip + ease.hip - body.waist - ease.waist;
  return Math.atan(wider / 8 / body.hipDepth) + flare;
}

/** The seam on the centre panel, at its +x side; it meets the armhole square. */
function centreSeam(body: Body, half: Half): PanelSeam {
  const shape = shapes[half];
  const waist: Point = [shape.waist * body.waist, 0];
  const bust: Point = [waist[0] + shape.out, shape.bust * body.backLength];
  const armhole: Point = [shoulderTip(body)[0] - shape.inward, underarmHeight(body) + shape.up];
  return {
    skirt: skirtSeam(`the ${half} panel seam`, waist, hipLean(body), skirtLength),
    bodice: bodiceSeam(waist, bust),
    top: curve(bust, upright, armhole, plus([0, 0], left(leaning(-shape.lean)), -1)),
  };
}

/** The side panel's edge of that seam, for a waist at the origin and cloth at +x: every part is trued to the other side. */
function sideEdge(body: Body, half: Half): PanelSeam {
  const shape = shapes[half];
  const centre = centreSeam(body, half);
  const bodiceAt = (height: number): Curve => bodiceSeam([0, 0], [-shape.sideOut, height]);
  const bodice = bodiceAt(
    trueTo(
      'the panel seam below the bust',
      length(centre.bodice),
      (y) => length(bodiceAt(y)),
      5,
      40,
    ),
  );
  const topAt = (rise: number): Curve =>
    curve(bodice.to, upright, plus(bodice.to, [shape.sideBack, rise]), heading(centre.top, 1));
  return {
    skirt: skirtSeam('the side panel', [0, 0], -hipLean(body), length(centre.skirt)),
    bodice,
    top: topAt(
      trueTo('the panel seam above the bust', length(centre.top), (y) => length(topAt(y)), 1, 40),
    ),
  };
}

const partNames = ['hem', 'hip', 'waist', 'bust', 'top'] as const;

/** The five edges of a front panel seam: it is parted where the diagonal ends, at either side of the body. */
function frontEdges({skirt, bodice, top}: PanelSeam): readonly Curve[] {
  const above = diagonal.belowBust;
  const parted = (what: string, whole: Curve, rest: number): Curve[] =>
    splitAtLengths(what, whole, [length(whole) - rest]);
  return [
    ...parted('the diagonal at the hip', skirt, diagonal.belowWaist),
    ...parted('the diagonal below the bust', bodice, above),
    top,
  ];
}

/** Armhole and shoulder of a centre panel, at its +x side. */
function topOf(body: Body, half: Half, seam: PanelSeam): readonly Edge[] {
  const tip = shoulderTip(body);
  return [
    edge('armhole', curve(seam.top.to, leaning(-shapes[half].lean), tip, leaning(shoulderSlope))),
    edge('shoulder', line(tip, neckPoint(body))),
  ];
}

const neckline = (body: Body, half: Half): Edge =>
  edge('neckline', reversed(roundNeckline(neckPoint(body), neckDepth[half], shoulderSlope)));

const onSide = (side: 'left' | 'right', edges: readonly Edge[]): Edge[] =>
  edges.map(({name, curve: one}) =>
    edge(`${name} ${side}`, side === 'left' ? one : reversed(mirrored(one))),
  );

/** The two pieces of the front: above the diagonal and below it. */
function fronts(body: Body): readonly [Panel, Panel] {
  const seam = centreSeam(body, 'front');
  const parts = frontEdges(seam).map((one, k) => edge(`seam ${partNames[k] ?? ''}`, one));
  const upLeft = onSide('left', parts);
  const downRight = onSide('right', parts).reverse();
  const top = topOf(body, 'front', seam);
  const [low, high] = [upLeft[1]?.curve.from, downRight[1]?.curve.to];
  if (!low || !high) throw new Error('the front panel seam has too few parts');
  const straight = heading(line(high, low), 0);
  const across = curve(high, turned(straight, bend), low, turned(straight, -bend));
  const placement = hung(body, 'front', 10);
  return [
    {
      name: 'front_upper',
      edges: [
        ...upLeft.slice(1),
        ...onSide('left', top),
        neckline(body, 'front'),
        ...onSide('right', top).reverse(),
        ...downRight.slice(0, 2),
        edge('diagonal', across),
      ],
      placement,
    },
    {
      name: 'front_lower',
      edges: [
        edge('hem', squareBelow(mirrored(seam.skirt), seam.skirt)),
        ...upLeft.slice(0, 1),
        edge('diagonal', reversed(across)),
        ...downRight.slice(2),
      ],
      placement,
    },
  ];
}

function back(body: Body): Panel {
  const seam = centreSeam(body, 'back');
  return symmetricPanel(
    'back',
    {
      bottom: edge('hem', squareBelow(mirrored(seam.skirt), seam.skirt)),
      half: [
        edge('seam skirt', seam.skirt),
        edge('seam bodice', seam.bodice),
        edge('seam top', seam.top),
        ...topOf(body, 'back', seam),
      ],
      top: neckline(body, 'back'),
      side: 'right',
    },
    hung(body, 'back', 10),
  );
}

/** The panels under the arms. Origin: the waist, at the front edge. */
function sidePanels(body: Body): readonly [Panel, Panel] {
  const girth = (body.waist + ease.waist) / 2;
  const width = girth - (shapes.front.waist + shapes.back.waist) * body.waist;
  const front = sideEdge(body, 'front');
  const rear = sideEdge(body, 'back');
  const atBack = (one: Curve): Curve => moved(mirrored(one), [width, 0]);
  const [skirt, bodice, top] = [rear.skirt, rear.bodice, rear.top].map(atBack);
  if (!skirt || !bodice || !top) throw new Error('the back panel seam has too few parts');
  const sunk = (top.to[1] + front.top.to[1]) / 2 - underarmHeight(body);
  const armhole = curve(
    top.to,
    left(heading(top, 1)),
    front.top.to,
    left(heading(front.top, 1)),
    sunk / 0.75,
    sunk / 0.75,
  );
  return pairOf(
    'side_panel',
    'left',
    [
      edge('hem', squareBelow(front.skirt, skirt)),
      edge('back seam skirt', skirt),
      edge('back seam bodice', bodice),
      edge('back seam top', top),
      edge('armhole', armhole),
      ...frontEdges(front)
        .map((one, k) => edge(`front seam ${partNames[k] ?? ''}`, reversed(one)))
        .reverse(),
    ],
    {
      translation: [radiusOf(body.bust) + 10, body.waistHeight, width / 2],
      rotation: [0, 90, 0],
    },
  );
}

/** Each part of a front panel seam is sewn to the front piece that it lies beside. */
function frontSeams(): Seam[] {
  const upper = {left: ['hip', 'waist', 'bust', 'top'], right: ['bust', 'top']};
  return (['left', 'right'] as const).flatMap((side) =>
    partNames.map((part) =>
      sew(
        'panel',
        `Front panel seam at the ${part}, ${side}`,
        [upper[side].includes(part) ? 'front_upper' : 'front_lower', `seam ${part} ${side}`],
        [`side_panel_${side}`, `front seam ${part}`],
      ),
    ),
  );
}

export function draftAsymmetricDress(body: Body): Garment {
  return {
    name: 'asymmetric-dress',
    title: 'Asymmetric dress',
    panels: [...fronts(body), ...sidePanels(body), back(body)],
    seams: [
      sew('front', 'Diagonal', ['front_upper', 'diagonal'], ['front_lower', 'diagonal'], {
        notches: [0.3, 0.7],
      }),
      ...frontSeams(),
      ...['skirt', 'bodice', 'top'].flatMap((part) =>
        onBothSides(
          'panel',
          `Back panel seam, ${part}`,
          ['back', `seam ${part} *`],
          ['side_panel_*', `back seam ${part}`],
        ),
      ),
      ...onBothSides('shoulder', 'Shoulder', ['front_upper', 'shoulder *'], ['back', 'shoulder *']),
    ],
    symmetries: [['back'], ['side_panel_left', 'side_panel_right']],
  };
}
