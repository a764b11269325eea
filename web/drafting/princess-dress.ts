/**
 * A sleeveless princess-seam dress: centre front, two side fronts with a bust dart, two side backs, two centre backs.
 * Every panel is drafted for the +x side of the view onto its face; the height of the waist is y = 0 throughout.
 */
import {radiusOf, type Body} from './body.js';
import {
  across,
  curve,
  degrees,
  leaning,
  left,
  line,
  middle,
  minus,
  moved,
  norm,
  plus,
  reversed,
  turned,
  velocity,
  type Curve,
  type Point,
} from './geometry.js';
import {bodiceSeam, skirtSeam} from './fitted-seams.js';
import {
  backPrincess,
  centreLine,
  frontPrincess,
  shoulderSlope,
  sideLine,
  sidePanelWaist,
  sideSeam,
  skirtLength,
  type SeamLine,
} from './princess-seams.js';
import {edge, onBothSides, pairOf, sew, symmetricPanel, type Garment, type Panel} from './panel.js';

const neckDepth = {front: 13, back: 3};
/** Shoulder seam: the part on the centre panel, and the whole. */
const shoulder = {centre: 3.6, whole: 8.2};

const neckPoint = (body: Body): Point => [body.neck / 5 + 2, body.backLength + 1.6];
/** A point of the shoulder seam, counted from the neck. */
const onShoulder = (neck: Point, distance: number): Point =>
  plus(neck, [Math.cos(shoulderSlope), -Math.sin(shoulderSlope)], distance);

/** Hem, square to both seams it joins; both are given upwards from the hem. */
function hemBetween(from: Curve, to: Curve): Curve {
  const square = (seam: Curve): Point => {
    const up = velocity(seam, 0);
    return plus([0, 0], left(up), -1 / norm(up));
  };
  return curve(from.from, square(from), to.from, square(to));
}

function centreFront(body: Body): {readonly panel: Panel; readonly line: SeamLine} {
  const neck = neckPoint(body);
  const point = onShoulder(neck, shoulder.centre);
  const seam = centreLine(body, frontPrincess(body), point);
  const up = velocity(seam.skirt, 0);
  const hem = across(seam.skirt.from, plus([0, 0], left(up), -1 / norm(up)));
  const neckline = reversed(
    across(neck, leaning(shoulderSlope), neckDepth.front / 0.75 / Math.cos(shoulderSlope)),
  );
  const panel = symmetricPanel(
    'centre_front',
    {
      bottom: edge('hem', hem),
      half: [
        edge('princess skirt', seam.skirt),
        edge('princess waist', seam.waist),
        edge('princess top', seam.top),
        edge('shoulder', line(point, neck)),
      ],
      top: edge('neckline', neckline),
      side: 'left',
    },
    {translation: [0, body.waistHeight, radiusOf(body.bust) + 10], rotation: [0, 0, 0]},
  );
  return {panel, line: seam};
}

function centreBacks(body: Body): {
  readonly panels: readonly [Panel, Panel];
  readonly line: SeamLine;
} {
  const neck = neckPoint(body);
  const point = onShoulder(neck, shoulder.centre);
  const seam = centreLine(body, backPrincess(body), point);
  const nape: Point = [0, neck[1] - neckDepth.back];
  // the centre back is hollowed at the waist and flares a little below it
  const waist: Point = [1.2, 0];
  const top = reversed(bodiceSeam(waist, nape));
  const skirt = reversed(skirtSeam('the centre back', waist, degrees(-2.5), skirtLength));
  const neckline = curve(
    neck,
    leaning(Math.PI + shoulderSlope),
    nape,
    [-1, 0],
    0.6 * neckDepth.back,
    0.6 * neck[0],
  );
  const panels = pairOf(
    'centre_back',
    'right',
    [
      edge('hem', hemBetween(reversed(skirt), seam.skirt)),
      edge('princess skirt', seam.skirt),
      edge('princess waist', seam.waist),
      edge('princess top', seam.top),
      edge('shoulder', line(point, neck)),
      edge('neckline', neckline),
      edge('centre top', top),
      edge('centre skirt', skirt),
    ],
    {translation: [-1.5, body.waistHeight, -radiusOf(body.bust) - 10], rotation: [0, 180, 0]},
  );
  return {panels, line: seam};
}

/** Armhole and shoulder of a side panel, from the underarm up; the armhole is square to the seams at both ends. */
function sideTop(
  underarm: Point,
  alongSide: Point,
  seam: SeamLine,
  slope: number,
  scoop: number,
): readonly [Curve, Curve] {
  const tip = plus(
    seam.top.to,
    [Math.cos(slope), -Math.sin(slope)],
    shoulder.whole - shoulder.centre,
  );
  return [
    curve(underarm, left(alongSide), tip, leaning(slope), scoop, 0.5 * (tip[1] - underarm[1])),
    line(tip, seam.top.to),
  ];
}

const inward = ({skirt, waist, top}: SeamLine): readonly [Curve, Curve, Curve] => [
  reversed(top),
  reversed(waist),
  reversed(skirt),
];

function sideFronts(body: Body, centre: SeamLine): readonly [Panel, Panel] {
  const princess = frontPrincess(body);
  const seam = sideLine(body, princess, centre);
  const side = sideSeam(body);
  const out: Point = [sidePanelWaist(body, princess), 0];
  const skirt = moved(side.skirt, out);
  const waist = moved(side.waist, out);

  // the dart turns the panel above it about the bust, so it opens by that turn; its tip stays short of the bust
  const bust = seam.waist.to;
  const lower = waist.to;
  const intake = body.bust * 0.032;
  const upper = plus(
    bust,
    turned(minus(lower, bust), 2 * Math.asin(intake / 2 / norm(minus(lower, bust)))),
  );
  const mouth = middle(lower, upper);
  const tip = plus(bust, minus(mouth, bust), 0.24);
  // sewn, the side seam runs straight on over the dart
  const opening = 2 * Math.asin(intake / 2 / norm(minus(lower, tip)));
  const along = turned(side.lean, opening);
  const underarm = plus(upper, along, side.upper);

  const [armhole, shoulderSeam] = sideTop(underarm, along, seam, princess.sideSlope, 6.2);
  const [top, middlePart, skirtPart] = inward(seam);
  return pairOf(
    'side_front',
    'left',
    [
      edge('hem', hemBetween(seam.skirt, skirt)),
      edge('side skirt', skirt),
      edge('side waist', waist),
      edge('dart lower', line(lower, tip)),
      edge('dart upper', line(tip, upper)),
      edge('side top', line(upper, underarm)),
      edge('armhole', armhole),
      edge('shoulder', shoulderSeam),
      edge('princess top', top),
      edge('princess waist', middlePart),
      edge('princess skirt', skirtPart),
    ],
    {
      translation: [radiusOf(body.bust) * 0.8, body.waistHeight, radiusOf(body.bust) + 4],
      rotation: [0, 40, 0],
    },
  );
}

function sideBacks(body: Body, centre: SeamLine): readonly [Panel, Panel] {
  const princess = backPrincess(body);
  const seam = sideLine(body, princess, centre);
  const side = sideSeam(body);
  const out: Point = [sidePanelWaist(body, princess), 0];
  const waist = moved(side.waist, out);
  const underarm = plus(waist.to, side.lean, side.upper);
  const [armhole, shoulderSeam] = sideTop(underarm, side.lean, seam, princess.sideSlope, 4.6);
  const [top, middlePart, skirtPart] = inward(seam);
  const skirt = moved(side.skirt, out);
  return pairOf(
    'side_back',
    'right',
    [
      edge('hem', hemBetween(seam.skirt, skirt)),
      edge('side skirt', skirt),
      edge('side waist', waist),
      edge('side top', line(waist.to, underarm)),
      edge('armhole', armhole),
      edge('shoulder', shoulderSeam),
      edge('princess top', top),
      edge('princess waist', middlePart),
      edge('princess skirt', skirtPart),
    ],
    {
      translation: [-radiusOf(body.bust) * 0.8, body.waistHeight, -radiusOf(body.bust) - 4],
      rotation: [0, -140, 0],
    },
  );
}

export function draftPrincessDress(body: Body): Garment {
  const front = centreFront(body);
  const back = centreBacks(body);
  const parts = {skirt: 'below the waist', waist: 'at the waist', top: 'above the bust'};
  const along = Object.entries(parts);
  return {
    name: 'princess-dress',
    title: 'Princess dress',
    panels: [
      front.panel,
      ...sideFronts(body, front.line),
      ...sideBacks(body, back.line),
      ...back.panels,
    ],
    seams: [
      ...along.flatMap(([part, where]) =>
        onBothSides(
          'princess',
          `Front princess seam ${where}`,
          ['side_front_*', `princess ${part}`],
          ['centre_front', `princess ${part} *`],
          {notches: [0.5]},
        ),
      ),
      ...onBothSides(
        'dart',
        'Bust dart',
        ['side_front_*', 'dart lower'],
        ['side_front_*', 'dart upper'],
      ),
      ...along.flatMap(([part, where]) =>
        onBothSides(
          'side',
          `Side seam ${where}`,
          ['side_front_*', `side ${part}`],
          ['side_back_*', `side ${part}`],
        ),
      ),
      ...onBothSides(
        'shoulder',
        'Outer shoulder',
        ['side_front_*', 'shoulder'],
        ['side_back_*', 'shoulder'],
      ),
      ...onBothSides(
        'shoulder',
        'Inner shoulder',
        ['centre_front', 'shoulder *'],
        ['centre_back_*', 'shoulder'],
      ),
      ...along.flatMap(([part, where]) =>
        onBothSides(
          'princess',
          `Back princess seam ${where}`,
          ['side_back_*', `princess ${part}`],
          ['centre_back_*', `princess ${part}`],
          {notches: [0.48, 0.52]},
        ),
      ),
      ...(['top', 'skirt'] as const).map((part) =>
        sew(
          'centre',
          `Centre back ${part === 'top' ? 'above' : 'below'} the waist`,
          ['centre_back_left', `centre ${part}`],
          ['centre_back_right', `centre ${part}`],
          {notches: [0.5]},
        ),
      ),
    ],
    symmetries: [
      ['centre_front'],
      ['side_front_left', 'side_front_right'],
      ['side_back_left', 'side_back_right'],
      ['centre_back_left', 'centre_back_right'],
    ],
  };
}
