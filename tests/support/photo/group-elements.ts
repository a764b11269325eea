/**
 * The 17 wallpaper groups as lists of general positions, one per linear part, independent of the
 * core, whose table comes from generators. Lattice coordinates u, v follow the conventions of the
 * print file: mirrors of pm, the glides of pg, the mirrors of pmg and those of p31m along w1, the
 * mirror of cm along w1 + w2, 60 degrees between w1 and w2 of a hexagonal lattice.
 */
import type {GroupName} from '@/model/print/repeating-print.js';

/** (u, v) -> (m0 u + m1 v + a0, m2 u + m3 v + a1); only the shift modulo 1 counts. */
interface Element {
  readonly m: readonly [number, number, number, number];
  readonly a: readonly [number, number];
}

const turns3 = ['u,v', '-u-v,u', 'v,-u-v'];
const turns4 = ['u,v', '-v,u', '-u,-v', 'v,-u'];
const turns6 = ['u,v', '-v,u+v', '-u-v,u', '-u,-v', 'v,-u-v', 'u+v,-u'];
const alongSides = ['u+v,-v', '-u,u+v', '-v,-u'];
const acrossSides = ['v,u', '-u-v,v', 'u,-u-v'];

const positions: Readonly<Record<GroupName, readonly string[]>> = {
  p1: ['u,v'],
  p2: ['u,v', '-u,-v'],
  pm: ['u,v', 'u,-v'],
  pg: ['u,v', 'u+1/2,-v'],
  cm: ['u,v', 'v,u'],
  pmm: ['u,v', '-u,-v', 'u,-v', '-u,v'],
  pmg: ['u,v', '-u,-v', 'u,-v+1/2', '-u,v+1/2'],
  pgg: ['u,v', '-u,-v', 'u+1/2,-v+1/2', '-u+1/2,v+1/2'],
  cmm: ['u,v', '-u,-v', 'v,u', '-v,-u'],
  p4: turns4,
  p4m: [...turns4, 'u,-v', '-u,v', 'v,u', '-v,-u'],
  p4g: [...turns4, 'u+1/2,-v+1/2', '-u+1/2,v+1/2', 'v+1/2,u+1/2', '-v+1/2,-u+1/2'],
  p3: turns3,
  p3m1: [...turns3, ...acrossSides],
  p31m: [...turns3, ...alongSides],
  p6: turns6,
  p6m: [...turns6, ...acrossSides, ...alongSides],
};

export const allGroups = Object.keys(positions) as readonly GroupName[];

/** Coefficient of `letter` in a sum such as -u-v or u+1/2. */
function factor(sum: string, letter: 'u' | 'v'): number {
  const found = new RegExp(`([+-]?)${letter}`).exec(sum);
  return found ? (found[1] === '-' ? -1 : 1) : 0;
}

function parsed(position: string): Element {
  const [x = '', y = ''] = position.split(',');
  return {
    m: [factor(x, 'u'), factor(x, 'v'), factor(y, 'u'), factor(y, 'v')],
    a: [x.endsWith('1/2') ? 0.5 : 0, y.endsWith('1/2') ? 0.5 : 0],
  };
}

/** One element per linear part; the first is the identity. */
export const elementsOf = (group: GroupName): readonly Element[] => positions[group].map(parsed);

export type Shape = 'oblique' | 'rectangular' | 'rhombic' | 'square' | 'hexagonal';

const shapes: Readonly<Record<Shape, readonly GroupName[]>> = {
  oblique: ['p1', 'p2'],
  rectangular: ['pm', 'pg', 'pmm', 'pmg', 'pgg'],
  rhombic: ['cm', 'cmm'],
  square: ['p4', 'p4m', 'p4g'],
  hexagonal: ['p3', 'p3m1', 'p31m', 'p6', 'p6m'],
};

/** Lattice shape that a group requires at least. */
export function shapeOf(group: GroupName): Shape {
  const found = (Object.keys(shapes) as Shape[]).find((shape) => shapes[shape].includes(group));
  if (!found) throw new RangeError(`no shape for ${group}`);
  return found;
}
