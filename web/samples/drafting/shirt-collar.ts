/**
 * A shirt collar on a stand, each in one piece that is its own mirror image. Origin: the middle of
 * the lower edge.
 */
import {leftOf, norm, plus, radians, type Point} from '../../src/model/geometry/vectors.js';
import {radiusOf, type Body} from './body.js';
import {
  across,
  curve,
  leaning,
  length,
  line,
  mirror,
  reversed,
  splitAtLengths,
  trueTo,
  velocity,
  type Curve,
} from './curves.js';
import {edge, symmetricPanel, type Panel, type Placement} from './panel.js';

/**
 * Lengths of one side of the neckline to which the stand is sewn, from the middle of the back to
 * the button stand. [cm]
 */
interface NecklineLengths {
  /** Length across the back, both sides. */
  readonly back: number;
  /** Length of the yoke's part on the front. */
  readonly yoke: number;
  /** Length from there to the centre front. */
  readonly front: number;
  readonly buttonStand: number;
}

const standHeight = {back: 3.1, front: 2.7};
/** Upward angle of the stand at its ends, so that it is close to the neck. */
const standRise = radians(14);
/** The collar's seam is concave, so that the collar falls over the stand. */
const collarFall = radians(8);
const collarHeight = 4.4;
/** Vector from the end of the collar's seam to its point. */
const collarPoint: Point = [1.3, 6.9];
const collarEdge = radians(8);

function behindTheNeck(body: Body, above: number): Placement {
  return {
    translation: [0, body.waistHeight + body.backLength + above, -radiusOf(body.neck) - 7],
    rotation: [0, 180, 0],
  };
}

export function standPanel(body: Body, neckline: NecklineLengths): Panel {
  const {back, yoke, front, buttonStand} = neckline;
  const middle: Point = [back / 2, 0];
  const along: Point = leaning(Math.PI / 2 - standRise);
  // straight across the back; the second handle ends on that line, so that the curve begins without
  // a bend
  const lowerAt = (width: number): Curve =>
    curve(
      middle,
      [1, 0],
      plus(middle, [width, 0.5 * width * along[1]]),
      along,
      width / 3,
      width / 2,
    );
  const whole = yoke + front + buttonStand;
  const lower = lowerAt(
    trueTo('the collar stand', whole, (w) => length(lowerAt(w)), whole / 2, whole),
  );
  const [onYoke, onFront, onStand] = splitAtLengths('the collar stand', lower, [yoke, front]);
  if (!onYoke || !onFront || !onStand) throw new Error('the collar stand has three parts');

  const forward = velocity(onFront, 1);
  const direction = plus([0, 0], forward, 1 / norm(forward));
  const top = plus(onFront.to, leftOf(direction), standHeight.front);
  const upper = across(top, direction, (top[1] - standHeight.back) / (0.75 * direction[1]));
  const end = curve(
    onStand.to,
    leftOf(along),
    top,
    plus([0, 0], direction, -1),
    0.6 * standHeight.front,
    0.6 * buttonStand,
  );
  return symmetricPanel(
    'stand',
    {
      bottom: edge('back', line(mirror(middle), middle)),
      half: [
        edge('yoke', onYoke),
        edge('front', onFront),
        edge('button stand', onStand),
        edge('end', end),
      ],
      top: edge('collar', reversed(upper)),
      side: 'right',
    },
    behindTheNeck(body, 6),
  );
}

/** @param seamLength  of the upper edge of the stand, in cm */
export function collarPanel(body: Body, seamLength: number): Panel {
  const seamAt = (x: number): Curve => across([x, 0], leaning(Math.PI / 2 + collarFall));
  const seam = seamAt(
    trueTo('the collar', seamLength, (x) => length(seamAt(x)), seamLength / 4, seamLength / 2),
  );
  const point = plus(seam.to, collarPoint);
  const hollow = 0.5 * seam.to[0] * Math.sin(collarFall);
  const sinks = point[1] - hollow - collarHeight;
  const outer = across(
    point,
    leaning(Math.PI / 2 - collarEdge),
    sinks / (0.75 * Math.sin(collarEdge)),
  );
  return symmetricPanel(
    'collar',
    {
      bottom: edge('stand', seam),
      half: [edge('end', line(seam.to, point))],
      top: edge('outer', reversed(outer)),
      side: 'right',
    },
    behindTheNeck(body, 12),
  );
}
