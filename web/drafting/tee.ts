/** A tee: front, back and two set-in sleeves. Origin of front and back: the middle of the waist line. */
import {radiusOf, type Body} from './body.js';
import {
  across,
  curve,
  degrees,
  leaning,
  left,
  length,
  line,
  mirror,
  mirrored,
  plus,
  reversed,
  trueTo,
  type Curve,
  type Point,
} from './geometry.js';
import {
  edge,
  onBothSides,
  pairOf,
  symmetricPanel,
  type Garment,
  type Panel,
  type Side,
} from './panel.js';

const bustEase = 12;
const hipEase = 6;
const sleeveEase = 7;
const capEase = {front: 1.0, back: 1.4};
const shoulderSlope = degrees(19);
const sideLean = degrees(3.5);
const neckDepth = {front: 9.5, back: 2.4};
const hemBelowWaist = 19;
const sleeveLength = 23;
/** The front is cut this much wider than the back, at each side seam. */
const forward = 0.5;
/** Handles of the armhole at the underarm and at the shoulder: a front armhole is scooped out further. */
const scoop = {front: [6.4, 9.5], back: [4.8, 10.5]} as const;
/** Handles of the sleeve cap at the underarm and at the top, as parts of its half width. */
const cap = {front: [0.5, 0.56], back: [0.38, 0.58]} as const;

type Half = 'front' | 'back';

/** The edges of the +x side, from the hem up to the neck, and the neckline. */
function bodyHalf(
  body: Body,
  half: Half,
): {
  readonly side: Curve;
  readonly armhole: Curve;
  readonly shoulder: Curve;
  readonly neckline: Curve;
} {
  const wider = half === 'front' ? forward : -forward;
  const underarm: Point = [
    (body.bust + bustEase) / 4 + wider,
    body.backLength - (body.bust / 10 + 13),
  ];
  const hem: Point = [(body.hip + hipEase) / 4 + wider, -hemBelowWaist];
  const neck: Point = [body.neck / 5 + 1.6, body.backLength + neckDepth.back];
  const tipX = body.shoulderWidth / 2 + 0.6;
  const tip: Point = [tipX, neck[1] - (tipX - neck[0]) * Math.tan(shoulderSlope)];

  // up the side, hollowed at the waist and square to a level hem
  const side = curve(hem, [0, 1], underarm, leaning(sideLean), 17, 13);
  // the armhole is square to the side seam and to the shoulder, so that it runs on from front to back
  const [atUnderarm, atShoulder] = scoop[half];
  const armhole = curve(
    underarm,
    left(leaning(sideLean)),
    tip,
    leaning(shoulderSlope),
    atUnderarm,
    atShoulder,
  );
  // so does the neckline; a cubic sinks to 3/4 of its handles
  const sunk = neckDepth[half] / 0.75 / Math.cos(shoulderSlope);
  return {
    side,
    armhole,
    shoulder: line(tip, neck),
    neckline: reversed(across(neck, leaning(shoulderSlope), sunk)),
  };
}

function bodyPanel(body: Body, half: Half): Panel {
  const {side, armhole, shoulder, neckline} = bodyHalf(body, half);
  const positive: Side = half === 'front' ? 'left' : 'right';
  const away = radiusOf(body.bust) + 8;
  return symmetricPanel(
    half,
    {
      bottom: edge('hem', line(mirror(side.from), side.from)),
      half: [edge('side', side), edge('armhole', armhole), edge('shoulder', shoulder)],
      top: edge('neckline', neckline),
      side: positive,
    },
    half === 'front'
      ? {translation: [0, body.waistHeight, away], rotation: [0, 0, 0]}
      : {translation: [0, body.waistHeight, -away], rotation: [0, 180, 0]},
  );
}

/** Half a sleeve cap on its +x side, from the underarm up to the top, for the half width and the height of the cap. */
function capHalf(half: Half, width: number, height: number, taper: number): Curve {
  const [atUnderarm, atTop] = cap[half];
  return curve(
    [width, 0],
    left(leaning(taper)),
    [0, height],
    [-1, 0],
    atUnderarm * width,
    atTop * width,
  );
}

/** Left and right sleeve. Origin: on the line across both underarms, below the top of the cap. */
function sleeves(body: Body): readonly [Panel, Panel] {
  const armhole = {front: bodyHalf(body, 'front').armhole, back: bodyHalf(body, 'back').armhole};
  const taper = degrees(7);
  const widthAt = (half: Half, height: number): number =>
    trueTo(
      `the ${half} sleeve cap`,
      length(armhole[half]) + capEase[half],
      (w) => length(capHalf(half, w, height, taper)),
      4,
      60,
    );
  // a lower cap is wider: the height follows from the arm
  const height = trueTo(
    'the sleeve width',
    body.upperArm + sleeveEase,
    (h) => widthAt('front', h) + widthAt('back', h),
    4,
    18,
  );
  const capBack = capHalf('back', widthAt('back', height), height, taper);
  // on the wearer's left the front half lies at -x
  const capFront = reversed(mirrored(capHalf('front', widthAt('front', height), height, taper)));
  const down: Point = plus([0, 0], leaning(taper), -(sleeveLength - height));
  const hemBack = plus(capBack.from, down);
  const hemFront = plus(capFront.to, mirror(down));
  // a sleeve that narrows towards its hem has a hem that is hollow, square to both edges of the seam
  const square = left(leaning(taper));
  const hem = curve(hemFront, mirror(square), hemBack, plus([0, 0], square, -1));

  const tip = armhole.front.to;
  const hang = degrees(45);
  const clear = 6;
  return pairOf(
    'sleeve',
    'left',
    [
      edge('hem', hem),
      edge('underarm back', line(hemBack, capBack.from)),
      edge('cap back', capBack),
      edge('cap front', capFront),
      edge('underarm front', line(capFront.to, hemFront)),
    ],
    {
      translation: [
        tip[0] + clear + height * Math.sin(hang),
        body.waistHeight + tip[1] + clear - height * Math.cos(hang),
        0,
      ],
      rotation: [0, 90, 45],
    },
  );
}

export function draftTee(body: Body): Garment {
  return {
    name: 'tee',
    title: 'Tee',
    panels: [bodyPanel(body, 'front'), bodyPanel(body, 'back'), ...sleeves(body)],
    seams: [
      ...onBothSides('side', 'Side seam', ['front', 'side *'], ['back', 'side *'], {
        notches: [0.5],
      }),
      ...onBothSides('shoulder', 'Shoulder', ['front', 'shoulder *'], ['back', 'shoulder *']),
      ...onBothSides(
        'armhole',
        'Front armhole',
        ['sleeve_*', 'cap front'],
        ['front', 'armhole *'],
        {ease: capEase.front, notches: [0.55]},
      ),
      ...onBothSides('armhole', 'Back armhole', ['sleeve_*', 'cap back'], ['back', 'armhole *'], {
        ease: capEase.back,
        notches: [0.42, 0.47],
      }),
      ...onBothSides(
        'underarm',
        'Underarm',
        ['sleeve_*', 'underarm front'],
        ['sleeve_*', 'underarm back'],
      ),
    ],
    symmetries: [['front'], ['back'], ['sleeve_left', 'sleeve_right']],
  };
}
