/**
 * A sleeveless blouse: a straight yoke across the front, and below it two deep tucks, which run to
 * the hem. The front's edges end at the lines of the tucks, whose fabric is sewn to nothing.
 */
import {radians, type Point} from '../../src/model/geometry/vectors.js';
import {bodiceHalf, hung, roundNeckline, type BodiceStyle} from './bodice.js';
import type {Body} from './body.js';
import {line, mirror, moved, reversed, splitWhere, type Curve} from './curves.js';
import {
  edge,
  onBothSides,
  pleatBetween,
  sew,
  symmetricPanel,
  type Edge,
  type Garment,
  type Panel,
} from './panel.js';
import {strip} from './skirt-lines.js';

const style: BodiceStyle = {
  bustEase: 12,
  hipEase: 8,
  armholeDepth: 11,
  shoulderOut: -1.5,
  shoulderSlope: radians(19),
  neckOut: 1.6,
  neckDepth: {front: 8, back: 3},
  frontLower: 1.9,
  hemBelowWaist: 17,
  sideLean: radians(3.5),
  forward: 0.5,
  scoop: {front: 1.4, back: 0.8},
};
/** Fabric in a tuck: a repeat of most prints, within the solver's greatest change. */
const uptake = 9;
/** Distance of a tuck from the middle, as a share of the yoke's half width. */
const tuckAt = 0.45;
/** Height of the yoke's seam below the bottom of the neckline. [cm] */
const yokeBelowNeck = 4;

const frontHalf = (body: Body) => {
  const {side, armhole, shoulder} = bodiceHalf(body, 'front', style);
  const height = shoulder.to[1] - style.neckDepth.front - yokeBelowNeck;
  const [lower, upper] = splitWhere('the yoke', armhole, ([, y]) => y, height);
  return {side, lower, upper, shoulder};
};

/** The level edges of the front between its centre parts, tucks and side parts, from -x to +x. */
function levelEdges(name: string, [half, y]: Point, tuck: number): Edge[] {
  return strip(
    [-half - uptake, y],
    [
      [`${name} right`, half - tuck],
      [`${name} tuck right`, uptake],
      [`${name} middle`, 2 * tuck],
      [`${name} tuck left`, uptake],
      [`${name} left`, half - tuck],
    ],
  );
}

function frontPanel(body: Body): Panel {
  const {side, lower} = frontHalf(body);
  const tuck = tuckAt * lower.to[0];
  const outward = (curve: Curve, sign: 1 | -1): Curve => moved(curve, [sign * uptake, 0]);
  const other = (curve: Curve): Curve =>
    outward(
      reversed({
        from: mirror(curve.from),
        to: mirror(curve.to),
        ...(curve.controls && {controls: [mirror(curve.controls[0]), mirror(curve.controls[1])]}),
      }),
      -1,
    );
  const yoke = levelEdges('yoke', lower.to, tuck).map((part) => ({
    ...part,
    curve: reversed(part.curve),
  }));
  const drop = lower.to[1] - side.from[1];
  const tuckLine = (sign: 1 | -1) => {
    const inner: Point = [sign * tuck, lower.to[1]];
    return pleatBetween('tuck', inner, [sign * (tuck + uptake), lower.to[1]], drop);
  };
  return {
    name: 'front',
    edges: [
      ...levelEdges('hem', side.from, tuck),
      edge('side left', outward(side, 1)),
      edge('armhole left', outward(lower, 1)),
      ...yoke.reverse(),
      edge('armhole right', other(lower)),
      edge('side right', other(side)),
    ],
    placement: hung(body, 'front', 10),
    folds: [tuckLine(1), tuckLine(-1)],
  };
}

function yokePanel(body: Body): Panel {
  const {lower, upper, shoulder} = frontHalf(body);
  const tuck = tuckAt * lower.to[0];
  const low: Point = [tuck, lower.to[1]];
  const {translation, rotation} = hung(body, 'front', 8);
  return symmetricPanel(
    'yoke',
    {
      bottom: edge('lower middle', line(mirror(low), low)),
      half: [
        edge('lower', line(low, lower.to)),
        edge('armhole', upper),
        edge('shoulder', shoulder),
      ],
      top: edge(
        'neckline',
        reversed(roundNeckline(shoulder.to, style.neckDepth.front, style.shoulderSlope)),
      ),
      side: 'left',
    },
    {translation: [translation[0], translation[1] + 4, translation[2]], rotation},
  );
}

function backPanel(body: Body): Panel {
  const {side, armhole, shoulder} = bodiceHalf(body, 'back', style);
  return symmetricPanel(
    'back',
    {
      bottom: edge('hem', line(mirror(side.from), side.from)),
      half: [edge('side', side), edge('armhole', armhole), edge('shoulder', shoulder)],
      top: edge(
        'neckline',
        reversed(roundNeckline(shoulder.to, style.neckDepth.back, style.shoulderSlope)),
      ),
      side: 'right',
    },
    hung(body, 'back', 8),
  );
}

export function draftTuckedBlouse(body: Body): Garment {
  return {
    name: 'tucked-blouse',
    title: 'Tucked blouse',
    panels: [frontPanel(body), yokePanel(body), backPanel(body)],
    seams: [
      ...onBothSides('side', 'Side seam', ['front', 'side *'], ['back', 'side *'], {
        notches: [0.5],
      }),
      ...onBothSides('shoulder', 'Shoulder', ['yoke', 'shoulder *'], ['back', 'shoulder *']),
      sew('panel', 'Yoke, middle', ['yoke', 'lower middle'], ['front', 'yoke middle'], {
        notches: [0.5],
      }),
      ...onBothSides('panel', 'Yoke', ['yoke', 'lower *'], ['front', 'yoke *']),
    ],
    symmetries: [['front'], ['yoke'], ['back']],
  };
}
