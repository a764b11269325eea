/**
 * The pieces of the shirt except its collar: one front and one back, divided where the yoke begins.
 */
import {leftOf, minus, norm, plus, radians, type Point} from '../../src/model/geometry/vectors.js';
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
import {
  curve,
  length,
  line,
  mapped,
  mirror,
  reflectedIn,
  reversed,
  splitAtLengths,
  splitWhere,
  type Curve,
} from './curves.js';
import {edge, pairOf, symmetricPanel, type Panel} from './panel.js';
import {armholeLengths, hungSleeve, taperedSleeve} from './sleeve.js';

/** Fabric pleated into each centimetre of cuff. [cm] */
export const cuffPleats = 1.25;
const cuff = {ease: 6, height: 6.5};
/** Position of the cuff's opening: the part of the wrist in front of the slit. */
const slit = 0.72;
export const capEase = {front: 0.9, back: 1.2};
/** Distance from the centre front to the edge of the button stand. */
export const buttonStand = 1.75;
/** Extent of the yoke: below the shoulder on the front, below the nape on the back. */
const yokeReach = {front: 3.5, back: 9};
/** Length of the tails below the side seams. */
export const tails = {front: 6, back: 8};

const styleOf = (body: Body): BodiceStyle => ({
  bustEase: 16,
  hipEase: 12,
  armholeDepth: 14,
  shoulderOut: 1.2,
  shoulderSlope: radians(19),
  neckOut: 0.2,
  neckDepth: {front: body.neck / 5 - 0.4, back: 2.7},
  frontLower: 1.4,
  hemBelowWaist: 19,
  sideLean: radians(3),
  forward: 0,
  scoop: {front: 1.3, back: 0.5},
});

/** Front and back drafted without a yoke, and divided where the yoke begins. */
interface Cut {
  readonly halves: Readonly<Record<Half, BodiceHalf>>;
  readonly armhole: Readonly<Record<Half, {readonly body: Curve; readonly yoke: Curve}>>;
  /** The neckline from the shoulder down to the centre front. */
  readonly neckline: {readonly yoke: Curve; readonly body: Curve};
}

export function cutOf(body: Body): Cut {
  const style = styleOf(body);
  const halves = {
    front: bodiceHalf(body, 'front', style),
    back: bodiceHalf(body, 'back', style),
  };
  const {from: tip, to: neck} = halves.front.shoulder;
  const down = leftOf(minus(neck, tip));
  const below = (p: Point): number => {
    const [x, y] = minus(p, neck);
    return (x * down[0] + y * down[1]) / norm(down);
  };
  const neckline = halfNeckline(neck, style.neckDepth.front, style.shoulderSlope);
  const front = splitWhere('the yoke', halves.front.armhole, below, yokeReach.front);
  const height = body.backLength - yokeReach.back;
  const back = splitWhere('the yoke', halves.back.armhole, ([, y]) => y, height);
  const [onYoke, onBody] = splitWhere('the yoke', neckline, below, yokeReach.front);
  return {
    halves,
    armhole: {
      front: {body: front[0], yoke: front[1]},
      back: {body: back[0], yoke: back[1]},
    },
    neckline: {yoke: onYoke, body: onBody},
  };
}

function fronts(body: Body, {halves, armhole, neckline}: Cut): readonly [Panel, Panel] {
  const {side} = halves.front;
  const centre = neckline.body.to;
  const top: Point = [-buttonStand, centre[1]];
  const bottom: Point = [-buttonStand, side.from[1] - tails.front];
  const reach = side.from[0] + buttonStand;
  return pairOf(
    'front',
    'left',
    [
      edge('hem', curve(bottom, [1, 0], side.from, [1, 0], 0.6 * reach, 0.33 * reach)),
      edge('side', side),
      edge('armhole', armhole.front.body),
      edge('yoke', line(armhole.front.body.to, neckline.body.from)),
      edge('neckline', neckline.body),
      edge('button stand', line(centre, top)),
      edge('front edge', line(top, bottom)),
    ],
    hung(body, 'front', 8, 4),
  );
}

function backPanel(body: Body, {halves, armhole}: Cut): Panel {
  const {side} = halves.back;
  const low: Point = [0.3 * side.from[0], side.from[1] - tails.back];
  const reach = side.from[0] - low[0];
  const top = armhole.back.body.to;
  return symmetricPanel(
    'back',
    {
      bottom: edge('hem', line(mirror(low), low)),
      half: [
        edge('tail', curve(low, [1, 0], side.from, [1, 0], 0.5 * reach, 0.45 * reach)),
        edge('side', side),
        edge('armhole', armhole.back.body),
      ],
      top: edge('yoke', line(top, mirror(top))),
      side: 'right',
    },
    hung(body, 'back', 8),
  );
}

/** The whole back neckline. */
export const backNeckline = (body: Body, {halves}: Cut): Curve =>
  roundNeckline(halves.back.shoulder.to, styleOf(body).neckDepth.back, styleOf(body).shoulderSlope);

/**
 * The yoke, drawn as part of the back; the part over the shoulder is the front's, unfolded about
 * the shoulder line.
 */
function yokePanel(body: Body, cut: Cut): Panel {
  const {halves, armhole, neckline} = cut;
  const {from: tip, to: neck} = halves.front.shoulder;
  const onBack = minus(halves.back.shoulder.to, neck);
  const reflected = reflectedIn(tip, neck);
  const unfolded = (p: Point): Point => plus(reflected(p), onBack);
  const onArmhole = reversed(mapped(armhole.front.yoke, unfolded));
  const onNeckline = reversed(mapped(neckline.yoke, unfolded));
  const low = armhole.back.yoke.from;
  const {translation, rotation} = hung(body, 'back', 6);
  return symmetricPanel(
    'yoke',
    {
      bottom: edge('back', line(mirror(low), low)),
      half: [
        edge('armhole back', armhole.back.yoke),
        edge('armhole front', onArmhole),
        edge('front', line(onArmhole.to, onNeckline.from)),
        edge('neckline front', onNeckline),
      ],
      top: edge('neckline', reversed(backNeckline(body, cut))),
      side: 'right',
    },
    {translation: [translation[0], translation[1] + 4, translation[2]], rotation},
  );
}

/** Share of the cap's length, and of its ease, that is sewn to the yoke. */
export function yokeShare({armhole}: Cut, half: Half): number {
  const onYoke = length(armhole[half].yoke);
  return onYoke / (onYoke + length(armhole[half].body));
}

export function sleevesAndCuffs(body: Body, cut: Cut): readonly Panel[] {
  const cuffLength = body.wrist + cuff.ease;
  const {halves} = cut;
  const sleeveLength = body.armLength - 1 - cuff.height + 2;
  const {cap, tube} = taperedSleeve(
    armholeLengths(halves),
    {width: body.upperArm + 12, ease: capEase},
    sleeveLength,
    cuffLength * cuffPleats,
  );
  const [wristFront, wristBack] = splitAtLengths('the wrist', tube.hem, [length(tube.hem) * slit]);
  const [capBack, capBackYoke] = splitAtLengths('the cap', cap.back, [
    length(cap.back) * (1 - yokeShare(cut, 'back')),
  ]);
  const [capFrontYoke, capFront] = splitAtLengths('the cap', cap.front, [
    length(cap.front) * yokeShare(cut, 'front'),
  ]);
  if (!wristFront || !wristBack || !capBack || !capBackYoke || !capFrontYoke || !capFront) {
    throw new Error('the sleeve has a slit, and a yoke on either side of its top');
  }
  const tip = halves.front.armhole.to;
  const sleeves = pairOf(
    'sleeve',
    'left',
    [
      edge('wrist front', wristFront),
      edge('wrist back', wristBack),
      edge('underarm back', tube.underarmBack),
      edge('cap back', capBack),
      edge('cap back yoke', capBackYoke),
      edge('cap front yoke', capFrontYoke),
      edge('cap front', capFront),
      edge('underarm front', tube.underarmFront),
    ],
    hungSleeve(body, tip, cap.height),
  );
  const low: Point = [cuffLength / 2, 0];
  const high: Point = [cuffLength / 2, cuff.height];
  const underarm = plus(high, [-1, 0], slit * cuffLength);
  const cuffs = pairOf(
    'cuff',
    'left',
    [
      edge('lower', line(mirror(low), low)),
      edge('end front', line(low, high)),
      edge('upper front', line(high, underarm)),
      edge('upper back', line(underarm, mirror(high))),
      edge('end back', line(mirror(high), mirror(low))),
    ],
    hungSleeve(body, tip, cap.height, sleeveLength - cap.height + cuff.height + 4),
  );
  return [...sleeves, ...cuffs];
}

export const shirtBody = (body: Body, cut: Cut): readonly Panel[] => [
  ...fronts(body, cut),
  backPanel(body, cut),
  yokePanel(body, cut),
];
