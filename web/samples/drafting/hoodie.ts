/**
 * A hooded sweatshirt with dropped shoulders: front, back, sleeves, a hood of three pieces, ribs at
 * wrists and hem, and a kangaroo pocket on the front.
 */
import {radians, type Point} from '../../src/model/geometry/vectors.js';
import {
  bodiceHalf,
  halfNeckline,
  hung,
  roundNeckline,
  type BodiceHalf,
  type BodiceStyle,
  type Half,
} from './bodice.js';
import type {Body} from './body.js';
import {hoodPanels, strip} from './hood.js';
import {
  curve,
  evened,
  length,
  line,
  mirror,
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
  type Match,
  type Panel,
} from './panel.js';
import {setInOutline, setInSeams} from './set-in-sleeve.js';
import {armholeLengths, hungSleeve, taperedSleeve} from './sleeve.js';

/** Length of fabric that each centimetre of rib holds in. */
const ribStretch = {cuff: 1.3, band: 1.15};
const ribHeight = 6.5;
const cuffEase = 4;
const capEase = {front: 0.5, back: 0.7};

const styleOf = (body: Body): BodiceStyle => ({
  bustEase: 22,
  hipEase: 14,
  armholeDepth: 15.5,
  shoulderOut: 3.5,
  shoulderSlope: radians(18),
  neckOut: 2.4,
  neckDepth: {front: body.neck / 5 + 0.7, back: 2.8},
  frontLower: 1.2,
  hemBelowWaist: 13,
  sideLean: radians(2),
  forward: 0,
  scoop: {front: 1.6, back: 0.9},
});

/** The pocket on the front, above the hem: half widths and heights. [cm] */
const pocket = {foot: 16, side: 6, top: 9.5, height: 19};

/** Necklines of both halves with a dropped shoulder, each from the shoulder on. */
interface Necklines {
  readonly front: Curve;
  /** The neckline up to the strip of the hood, and across below it. */
  readonly back: Curve;
  readonly nape: Curve;
}

function necklinesOf(body: Body, {front, back}: Readonly<Record<Half, BodiceHalf>>): Necklines {
  const {neckDepth, shoulderSlope} = styleOf(body);
  const across = reversed(roundNeckline(back.shoulder.to, neckDepth.back, shoulderSlope));
  const onSide = (length(across) - strip.nape) / 2;
  const [side, nape] = splitAtLengths('the back neckline', across, [onSide, strip.nape]);
  if (!side || !nape) throw new Error('a back neckline in three parts');
  return {
    front: halfNeckline(front.shoulder.to, neckDepth.front, shoulderSlope),
    back: side,
    nape: evened(nape),
  };
}

function bodyPanel(
  body: Body,
  half: Half,
  {side, armhole, shoulder}: BodiceHalf,
  neck: Curve,
  nape?: Curve,
): Panel {
  return symmetricPanel(
    half,
    {
      bottom: edge('hem', line(mirror(side.from), side.from)),
      half: [
        edge('side', side),
        edge('armhole', armhole),
        edge('shoulder', shoulder),
        edge('neckline', neck),
      ],
      ...(nape && {top: edge('nape', nape)}),
      side: half === 'front' ? 'left' : 'right',
    },
    hung(body, half, 9),
  );
}

/**
 * A straight strip of rib, for a wrist or the hem; origin: the middle of its lower edge. Its grain
 * runs across the strip, like the ribs, so that it stretches around the body.
 */
function ribEdges(width: number): Edge[] {
  const low: Point = [width / 2, 0];
  const high: Point = [width / 2, ribHeight];
  return [
    edge('lower', line(mirror(low), low)),
    edge('end front', line(low, high)),
    edge('upper', line(high, mirror(high))),
    edge('end back', line(mirror(high), mirror(low))),
  ];
}

function bandPanel(body: Body, half: Half, hem: Point): Panel {
  const [lower, end, upper] = ribEdges((2 * hem[0]) / ribStretch.band);
  if (!lower || !end || !upper) throw new Error('a band has four edges');
  const {translation, rotation} = hung(body, half, 9);
  return symmetricPanel(
    `band_${half}`,
    {
      bottom: lower,
      half: [edge('end', end.curve)],
      top: upper,
      side: half === 'front' ? 'left' : 'right',
    },
    {
      translation: [translation[0], translation[1] + hem[1] - ribHeight - 4, translation[2]],
      rotation,
    },
  );
}

function sleevesAndCuffs(body: Body, halves: Readonly<Record<Half, BodiceHalf>>): readonly Panel[] {
  const cuffLength = body.wrist + cuffEase;
  const sleeveLength = body.armLength - styleOf(body).shoulderOut - ribHeight + 3;
  const {cap, tube} = taperedSleeve(
    armholeLengths(halves),
    {width: body.upperArm + 14, ease: capEase},
    sleeveLength,
    cuffLength * ribStretch.cuff,
  );
  const tip = halves.front.armhole.to;
  return [
    ...pairOf(
      'sleeve',
      'left',
      setInOutline(cap, tube, 'wrist'),
      hungSleeve(body, tip, cap.height),
    ),
    ...pairOf(
      'cuff',
      'left',
      ribEdges(cuffLength),
      hungSleeve(body, tip, cap.height, sleeveLength - cap.height + ribHeight + 4),
    ),
  ];
}

/** The pocket, drawn in the coordinates of the front. */
function pocketPanel(body: Body, hem: number): {readonly panel: Panel; readonly matches: Match[]} {
  const foot: Point = [pocket.foot, hem];
  const mouth: Point = [pocket.foot, hem + pocket.side];
  const top: Point = [pocket.top, hem + pocket.height];
  // the opening for the hand is concave
  const opening = curve(mouth, [-0.7, 0.71], top, [-0.2, 0.98]);
  const {translation, rotation} = hung(body, 'front', 14);
  const on = (name: string, line: readonly Point[]): Match => ({
    name,
    a: {panel: 'pocket', line},
    b: {panel: 'front', line},
  });
  return {
    panel: symmetricPanel(
      'pocket',
      {
        bottom: edge('foot', line(mirror(foot), foot)),
        half: [edge('side', line(foot, mouth)), edge('opening', opening)],
        top: edge('top', line(top, mirror(top))),
        side: 'left',
      },
      {translation, rotation},
    ),
    matches: [
      on('Pocket, top', [mirror(top), top]),
      on('Pocket, left side', [foot, mouth]),
      on('Pocket, right side', [mirror(foot), mirror(mouth)]),
    ],
  };
}

export function draftHoodie(body: Body): Garment {
  const style = styleOf(body);
  const halves = {
    front: bodiceHalf(body, 'front', style),
    back: bodiceHalf(body, 'back', style),
  };
  const necklines = necklinesOf(body, halves);
  const {panel: pocketPiece, matches} = pocketPanel(body, halves.front.side.from[1]);
  return {
    name: 'hoodie',
    title: 'Hoodie',
    panels: [
      bodyPanel(body, 'front', halves.front, necklines.front),
      bodyPanel(body, 'back', halves.back, necklines.back, necklines.nape),
      ...sleevesAndCuffs(body, halves),
      ...hoodPanels(body, {front: length(necklines.front), back: length(necklines.back)}),
      bandPanel(body, 'front', halves.front.side.from),
      bandPanel(body, 'back', halves.back.side.from),
      pocketPiece,
    ],
    seams: [
      ...onBothSides('side', 'Side seam', ['front', 'side *'], ['back', 'side *'], {
        notches: [0.5],
      }),
      ...onBothSides('shoulder', 'Shoulder', ['front', 'shoulder *'], ['back', 'shoulder *']),
      ...setInSeams(capEase, {front: ['front', 'armhole *'], back: ['back', 'armhole *']}),
      ...onBothSides('gathered', 'Cuff', ['sleeve_*', 'wrist'], ['cuff_*', 'upper'], {
        gathers: ribStretch.cuff,
      }),
      ...onBothSides('underarm', 'Cuff end', ['cuff_*', 'end front'], ['cuff_*', 'end back']),
      ...onBothSides('collar', 'Hood, front', ['hood_*', 'neck front'], ['front', 'neckline *']),
      ...onBothSides('collar', 'Hood, back', ['hood_*', 'neck back'], ['back', 'neckline *']),
      sew('collar', 'Hood, nape', ['hood_centre', 'neck'], ['back', 'nape']),
      ...onBothSides('centre', 'Hood seam', ['hood_*', 'centre'], ['hood_centre', 'side *'], {
        notches: [0.3, 0.7],
      }),
      ...(['front', 'back'] as const).map((half) =>
        sew('gathered', `Hem band, ${half}`, [half, 'hem'], [`band_${half}`, 'upper'], {
          gathers: ribStretch.band,
          notches: [0.5],
        }),
      ),
      ...onBothSides('side', 'Hem band, side', ['band_front', 'end *'], ['band_back', 'end *']),
    ],
    matches,
    symmetries: [
      ['front'],
      ['back'],
      ['sleeve_left', 'sleeve_right'],
      ['cuff_left', 'cuff_right'],
      ['hood_left', 'hood_right'],
      ['hood_centre'],
      ['band_front'],
      ['band_back'],
      ['pocket'],
    ],
  };
}
