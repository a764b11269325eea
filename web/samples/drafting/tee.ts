/** A tee: front, back and two set-in sleeves. */
import {radians} from '../../src/model/geometry/vectors.js';
import {bodiceHalf, hung, roundNeckline, type BodiceStyle, type Half} from './bodice.js';
import type {Body} from './body.js';
import {line, mirror, reversed} from './curves.js';
import {edge, onBothSides, pairOf, symmetricPanel, type Garment, type Panel} from './panel.js';
import {setInOutline, setInSeams} from './set-in-sleeve.js';
import {armholeLengths, hungSleeve, sleeveCap, sleeveTube} from './sleeve.js';

const style: BodiceStyle = {
  bustEase: 12,
  hipEase: 6,
  armholeDepth: 13,
  shoulderOut: 0.6,
  shoulderSlope: radians(19),
  neckOut: 1.6,
  neckDepth: {front: 8.4, back: 3},
  frontLower: 1.9,
  hemBelowWaist: 19,
  sideLean: radians(3.5),
  forward: 0.5,
  scoop: {front: 1.2, back: 0.6},
};
const capEase = {front: 1.0, back: 1.4};
const sleeve = {ease: 7, length: 23, taper: radians(7)};

function bodyPanel(body: Body, half: Half): Panel {
  const {side, armhole, shoulder} = bodiceHalf(body, half, style);
  const neckline = roundNeckline(shoulder.to, style.neckDepth[half], style.shoulderSlope);
  return symmetricPanel(
    half,
    {
      bottom: edge('hem', line(mirror(side.from), side.from)),
      half: [edge('side', side), edge('armhole', armhole), edge('shoulder', shoulder)],
      top: edge('neckline', reversed(neckline)),
      side: half === 'front' ? 'left' : 'right',
    },
    hung(body, half, 8),
  );
}

function sleeves(body: Body): readonly [Panel, Panel] {
  const halves = {
    front: bodiceHalf(body, 'front', style),
    back: bodiceHalf(body, 'back', style),
  };
  const cap = sleeveCap(armholeLengths(halves), {
    width: body.upperArm + sleeve.ease,
    ease: capEase,
    taper: sleeve.taper,
  });
  const tube = sleeveTube(cap, sleeve.taper, sleeve.length - cap.height);
  return pairOf(
    'sleeve',
    'left',
    setInOutline(cap, tube),
    hungSleeve(body, halves.front.armhole.to, cap.height),
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
      ...setInSeams(capEase, {front: ['front', 'armhole *'], back: ['back', 'armhole *']}),
    ],
    symmetries: [['front'], ['back'], ['sleeve_left', 'sleeve_right']],
  };
}
