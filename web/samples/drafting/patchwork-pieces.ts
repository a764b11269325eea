/**
 * The patches of the jacket. A front or back is divided by rows, level lines at the same heights on
 * both, and by one column on each side, which bends to meet the shoulder square. Sleeves are
 * divided along the top of the arm and by rows that are square to the underarm seam. Where four
 * patches meet, all their lines continue.
 */
import {minus, plus, radians, type Point} from '../../src/model/geometry/vectors.js';
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
  leaning,
  length,
  line,
  mirror,
  reversed,
  splitAtLengths,
  splitWhere,
  type Curve,
} from './curves.js';
import {edge, pairOf, symmetricPanel, type Edge, type Panel} from './panel.js';
import {armholeLengths, hungSleeve, sleeveTube, taperedSleeve} from './sleeve.js';

export const bodyRows = ['hem', 'waist', 'chest', 'shoulder'] as const;
export const sleeveRows = ['wrist', 'elbow', 'cap'] as const;
export const capEase: Readonly<Record<Half, number>> = {front: 0.8, back: 1.2};
const wristEase = 13;

/** A straight jacket: hem and underarm are equally wide. */
const styleOf = (body: Body): BodiceStyle => ({
  bustEase: 24,
  hipEase: body.bust + 24 - body.hip,
  armholeDepth: 15,
  shoulderOut: 2,
  shoulderSlope: radians(18),
  neckOut: 1.8,
  neckDepth: {front: body.neck / 5 + 0.9, back: 2.6},
  frontLower: 1.1,
  hemBelowWaist: 21,
  sideLean: 0,
  forward: 0,
  scoop: {front: 1, back: 0.4},
});

/** The lines that divide a front or a back. */
interface Division {
  readonly half: Half;
  /** The lower edge of each row. */
  readonly heights: readonly [number, number, number, number];
  /** x of the column's straight part. */
  readonly x: number;
  readonly underarm: Point;
  readonly armhole: {readonly chest: Curve; readonly shoulder: Curve};
  /** The column from the uppermost row up to the shoulder. */
  readonly column: Curve;
  readonly shoulder: {readonly outer: Curve; readonly inner: Curve};
}

const halfOf = (body: Body, half: Half): BodiceHalf => bodiceHalf(body, half, styleOf(body));

export function divisionOf(body: Body, half: Half): Division {
  const {side, armhole, shoulder} = halfOf(body, half);
  const {from: tip, to: neck} = shoulder;
  const backTip = halfOf(body, 'back').shoulder.from;
  const underarm = side.to;
  const hem = side.from[1];
  const chest = underarm[1] + 0.45 * (backTip[1] - underarm[1]);
  const step = (chest - hem) / 3;
  const [low, high] = splitWhere('the patches', armhole, ([, y]) => y, chest);
  const x = 0.47 * underarm[0];
  const slope = styleOf(body).shoulderSlope;
  // the end of a bend from upright to square on the shoulder
  const meets = plus(neck, minus(tip, neck), (x + 1.8 - neck[0]) / (tip[0] - neck[0]));
  return {
    half,
    heights: [hem, hem + step, hem + 2 * step, chest],
    x,
    underarm,
    armhole: {chest: low, shoulder: high},
    column: curve([x, chest], [0, 1], meets, leaning(slope)),
    shoulder: {outer: line(tip, meets), inner: line(meets, neck)},
  };
}

/**
 * The edges of a patch beside the side seam or armhole, from its lower edge round to the column.
 */
function sidePatch(
  {heights, x, underarm, armhole, column, shoulder}: Division,
  row: number,
): Edge[] {
  const low = heights[row] ?? 0;
  const high = heights[row + 1];
  const start: Point = [x, low];
  if (high === undefined) {
    return [
      edge('lower', line(start, armhole.shoulder.from)),
      edge('armhole', armhole.shoulder),
      edge('shoulder', shoulder.outer),
      edge('column', reversed(column)),
    ];
  }
  const foot: Point = [underarm[0], low];
  const isChest = underarm[1] < high;
  const top: Point = isChest ? armhole.chest.to : [underarm[0], high];
  return [
    edge('lower', line(start, foot)),
    edge('side', line(foot, isChest ? underarm : top)),
    ...(isChest ? [edge('armhole', armhole.chest)] : []),
    edge('upper', line(top, [x, high])),
    edge('column', line([x, high], start)),
  ];
}

/**
 * The edges of a patch between the middle of the body and the column, without those in the middle.
 */
function centrePatch({heights, x, column, shoulder}: Division, row: number): Edge[] {
  const low: Point = [x, heights[row] ?? 0];
  const high = heights[row + 1];
  return high === undefined
    ? [edge('column', column), edge('shoulder', shoulder.inner)]
    : [edge('column', line(low, [x, high]))];
}

function frontPatches(body: Body, division: Division): readonly Panel[] {
  const {heights, x} = division;
  const {neckDepth, shoulderSlope} = styleOf(body);
  const neckline = halfNeckline(division.shoulder.inner.to, neckDepth.front, shoulderSlope);
  return bodyRows.flatMap((name, row) => {
    const low = heights[row] ?? 0;
    const high = heights[row + 1];
    const foot: Point = [0, low];
    const top = high === undefined ? neckline.to : ([0, high] as const);
    return [
      ...pairOf(
        `front_${name}_centre`,
        'left',
        [
          edge('lower', line(foot, [x, low])),
          ...centrePatch(division, row),
          high === undefined ? edge('neckline', neckline) : edge('upper', line([x, high], top)),
          edge('front edge', line(top, foot)),
        ],
        hung(body, 'front', 8, 2),
      ),
      ...pairOf(`front_${name}_side`, 'left', sidePatch(division, row), hung(body, 'front', 8, 2)),
    ];
  });
}

function backPatches(body: Body, division: Division): readonly Panel[] {
  const {heights, x} = division;
  const {neckDepth, shoulderSlope} = styleOf(body);
  const neckline = roundNeckline(division.shoulder.inner.to, neckDepth.back, shoulderSlope);
  return bodyRows.flatMap((name, row) => {
    const low: Point = [x, heights[row] ?? 0];
    const high: Point | undefined =
      row + 1 < heights.length ? [x, heights[row + 1] ?? 0] : undefined;
    return [
      symmetricPanel(
        `back_${name}_centre`,
        {
          bottom: edge('lower', line(mirror(low), low)),
          half: centrePatch(division, row),
          top: high
            ? edge('upper', line(high, mirror(high)))
            : edge('neckline', reversed(neckline)),
          side: 'right',
        },
        hung(body, 'back', 8),
      ),
      ...pairOf(`back_${name}_side`, 'right', sidePatch(division, row), hung(body, 'back', 8)),
    ];
  });
}

export const bodyPatches = (body: Body): readonly Panel[] => [
  ...frontPatches(body, divisionOf(body, 'front')),
  ...backPatches(body, divisionOf(body, 'back')),
];

/** Share of the uppermost row in an armhole, and so of the part of the cap sewn to it. */
export function shoulderShare({armhole}: Division): number {
  const onShoulder = length(armhole.shoulder);
  return onShoulder / (onShoulder + length(armhole.chest));
}

/** Twelve patches: three rows, in front of and behind the top of the arm, on both sides. */
export function sleevePatches(body: Body): readonly Panel[] {
  const halves = {front: halfOf(body, 'front'), back: halfOf(body, 'back')};
  const {cap, tube, taper} = taperedSleeve(
    armholeLengths(halves),
    {width: body.upperArm + 17, ease: capEase},
    body.armLength - styleOf(body).shoulderOut + 1,
    body.wrist + wristEase,
  );
  const seam = length(tube.underarmBack);
  // along the underarm seam, from the wrist up; the uppermost row includes the cap
  const levels = [0, 0.44, 0.84].map((share) => {
    const {hem} = sleeveTube(cap, taper, seam * (1 - share));
    return splitWhere('the sleeve', hem, ([x]) => x, 0);
  });
  const onCap = (whole: Curve, share: number): Curve[] =>
    splitAtLengths('the cap', whole, [share * length(whole)]);
  const [backChest, backShoulder] = onCap(cap.back, 1 - shoulderShare(divisionOf(body, 'back')));
  const [frontShoulder, frontChest] = onCap(cap.front, shoulderShare(divisionOf(body, 'front')));
  if (!backChest || !backShoulder || !frontChest || !frontShoulder) {
    throw new Error('a cap in four parts');
  }
  const placement = hungSleeve(body, halves.front.armhole.to, cap.height);
  return sleeveRows.flatMap((name, row) => {
    const [front, back] = levels[row] ?? [];
    const [frontAbove, backAbove] = levels[row + 1] ?? [];
    if (!front || !back) throw new Error('a level for every row');
    const over = front.to;
    const top = frontAbove?.to ?? frontShoulder.from;
    return [
      ...pairOf(
        `sleeve_${name}_front`,
        'left',
        [
          edge('lower', front),
          edge('overarm', line(over, top)),
          ...(frontAbove
            ? [edge('upper', reversed(frontAbove))]
            : [edge('cap front shoulder', frontShoulder), edge('cap front chest', frontChest)]),
          edge('underarm', line(frontAbove?.from ?? frontChest.to, front.from)),
        ],
        placement,
      ),
      ...pairOf(
        `sleeve_${name}_back`,
        'left',
        [
          edge('lower', back),
          edge('underarm', line(back.to, backAbove?.to ?? backChest.from)),
          ...(backAbove
            ? [edge('upper', reversed(backAbove))]
            : [edge('cap back chest', backChest), edge('cap back shoulder', backShoulder)]),
          edge('overarm', line(top, over)),
        ],
        placement,
      ),
    ];
  });
}
