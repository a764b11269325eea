/**
 * A fitted dress whose front is divided by a diagonal seam, from under the bust at the wearer's
 * right down to the hip at the left. It has two front pieces without any symmetry, a back that is
 * its own mirror image, and a pair of side panels instead of side seams. The panel seams run into
 * the armholes. The height of the waist is y = 0 throughout.
 */
import {leftOf, radians, rotated} from '../../src/model/geometry/vectors.js';
import {hung, roundNeckline, type Half} from './bodice.js';
import {
  centreSeam,
  neckPoint,
  shapes,
  shoulderSlope,
  shoulderTip,
  sideEdge,
  sidePanelWaist,
  underarmHeight,
  type PanelSeam,
} from './asymmetric-seams.js';
import {radiusOf, type Body} from './body.js';
import {
  curve,
  leaning,
  length,
  line,
  mirrored,
  moved,
  reversed,
  splitAtLengths,
  type Curve,
} from './curves.js';
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

const neckDepth = {front: 10, back: 3};
/**
 * Ends of the diagonal: below the bust at the right and below the waist at the left, along the
 * panel seam. [cm]
 */
const diagonal = {belowBust: 8, belowWaist: 15};
/** Angle of the diagonal to the straight line at its ends. */
const bend = radians(9);

const partNames = ['hem', 'hip', 'waist', 'bust', 'top'] as const;
/**
 * Each part of a panel seam is marked below its middle, once at the front and twice at the back,
 * from the hem up.
 */
const frontNotch = 0.4;
const backNotches = {skirt: [0.4, 0.42], bodice: [0.38, 0.44], top: [0.34, 0.44]} as const;

/**
 * The five edges of a front panel seam: it is divided where the diagonal ends, on either side of
 * the body.
 */
function frontEdges({skirt, bodice, top}: PanelSeam): readonly Curve[] {
  const parted = (what: string, whole: Curve, rest: number): Curve[] =>
    splitAtLengths(what, whole, [length(whole) - rest]);
  return [
    ...parted('the diagonal at the hip', skirt, diagonal.belowWaist),
    ...parted('the diagonal below the bust', bodice, diagonal.belowBust),
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
  const across = curve(high, rotated(straight, bend), low, rotated(straight, -bend));
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
  const width = sidePanelWaist(body);
  const front = sideEdge(body, 'front');
  const rear = sideEdge(body, 'back');
  const atBack = (one: Curve): Curve => moved(mirrored(one), [width, 0]);
  const skirt = atBack(rear.skirt);
  const top = atBack(rear.top);
  const sunk = (top.to[1] + front.top.to[1]) / 2 - underarmHeight(body);
  const armhole = curve(
    top.to,
    leftOf(heading(top, 1)),
    front.top.to,
    leftOf(heading(front.top, 1)),
    sunk / 0.75,
    sunk / 0.75,
  );
  return pairOf(
    'side_panel',
    'left',
    [
      edge('hem', squareBelow(front.skirt, skirt)),
      edge('back seam skirt', skirt),
      edge('back seam bodice', atBack(rear.bodice)),
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

/** The seams between the parts of a front panel seam and the front piece beside each of them. */
function frontSeams(): Seam[] {
  const upper = {left: ['hip', 'waist', 'bust', 'top'], right: ['bust', 'top']};
  return (['left', 'right'] as const).flatMap((side) =>
    partNames.map((part) =>
      sew(
        'panel',
        `Front panel seam at the ${part}, ${side}`,
        [upper[side].includes(part) ? 'front_upper' : 'front_lower', `seam ${part} ${side}`],
        [`side_panel_${side}`, `front seam ${part}`],
        {notches: [side === 'left' ? frontNotch : 1 - frontNotch]},
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
        notches: [0.3, 0.62],
      }),
      ...frontSeams(),
      ...(['skirt', 'bodice', 'top'] as const).flatMap((part) =>
        onBothSides(
          'panel',
          `Back panel seam, ${part}`,
          ['back', `seam ${part} *`],
          ['side_panel_*', `back seam ${part}`],
          {notches: backNotches[part].map((share) => 1 - share)},
        ),
      ),
      ...onBothSides('shoulder', 'Shoulder', ['front_upper', 'shoulder *'], ['back', 'shoulder *']),
    ],
    symmetries: [['back'], ['side_panel_left', 'side_panel_right']],
  };
}
