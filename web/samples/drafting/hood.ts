/**
 * A hood in three pieces: two sides, and a strip between them from the nape over the head to the
 * face.
 */
import {distance, leftOf, plus, radians, type Point} from '../../src/model/geometry/vectors.js';
import {radiusOf, type Body} from './body.js';
import {
  curve,
  leaning,
  length,
  line,
  mirror,
  splitAtLengths,
  trueTo,
  type Curve,
} from './curves.js';
import {edge, pairOf, symmetricPanel, type Panel} from './panel.js';

/** Lengths of one side of the neckline to which the hood is sewn. [cm] */
interface HoodNeckline {
  readonly front: number;
  /** Length from the shoulder to the strip. */
  readonly back: number;
}

/** Width of the strip at the nape and at the face. [cm] */
export const strip = {nape: 7, face: 10};
/** Backward angle of the hood at the nape. */
const lean = radians(12);
/** Forward angle of the face edge towards its top. */
const faceLean = radians(4);
/** Height of the nape over the hood's centre front. [cm] */
const frontDrop = 2.5;

/** Height and depth follow the head. */
const height = ({head}: Body): number => 0.6 * head;

/** The edges of the left side, the face at -x. Origin: the corner of neckline, strip and nape. */
function side(body: Body, neckline: HoodNeckline): {neck: Curve; centre: Curve; face: Curve} {
  const faceUp = leaning(-faceLean);
  const across = plus([0, 0], leftOf(faceUp), -1);
  const out = leaning(lean);
  const neckAt = (x: number): Curve =>
    curve([-x, -frontDrop], across, [0, 0], plus([0, 0], leftOf(out), -1), 0.4 * x, 0.3 * x);
  const whole = neckline.front + neckline.back;
  const neck = neckAt(trueTo('the hood', whole, (x) => length(neckAt(x)), 0.6 * whole, whole));
  const rise = (height(body) + frontDrop) / faceUp[1];
  const top = plus(neck.from, faceUp, rise);
  const reach = distance(top, [0, 0]);
  const centre = curve([0, 0], out, top, plus([0, 0], across, -1), 0.56 * reach, 0.42 * reach);
  return {neck, centre, face: line(top, neck.from)};
}

export function hoodPanels(body: Body, neckline: HoodNeckline): readonly Panel[] {
  const {neck, centre, face} = side(body, neckline);
  const [neckFront, neckBack] = splitAtLengths('the hood', neck, [neckline.front]);
  if (!neckFront || !neckBack) throw new Error('a hood that the shoulder seam meets');
  const above = body.waistHeight + body.backLength + 6;
  const sides = pairOf(
    'hood',
    'left',
    [
      edge('neck front', neckFront),
      edge('neck back', neckBack),
      edge('centre', centre),
      edge('face', face),
    ],
    {translation: [radiusOf(body.head) + 6, above, -8], rotation: [0, 90, 0]},
  );

  const foot: Point = [strip.nape / 2, 0];
  const stripSide = (tall: number): Curve => curve(foot, [0, 1], [strip.face / 2, tall], [0, 1]);
  const along = length(centre);
  const edgeOfStrip = stripSide(
    trueTo('the strip of the hood', along, (tall) => length(stripSide(tall)), 0.9 * along, along),
  );
  const middle = symmetricPanel(
    'hood_centre',
    {
      bottom: edge('neck', line(mirror(foot), foot)),
      half: [edge('side', edgeOfStrip)],
      top: edge('face', line(edgeOfStrip.to, mirror(edgeOfStrip.to))),
      side: 'right',
    },
    {translation: [0, above, -radiusOf(body.head) - 12], rotation: [0, 180, 0]},
  );
  return [...sides, middle];
}
