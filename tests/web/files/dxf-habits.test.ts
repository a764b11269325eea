import {readFileSync} from 'node:fs';
import {fileURLToPath} from 'node:url';

import fc from 'fast-check';
import type {GarmentCodeSpecification} from 'seamwise/node';
import {describe, expect, it} from 'vitest';

import {edgeLine} from '@/model/garment/edge-curve.js';
import {readDrawing} from '@/files/read-drawing.js';
import {defaultChoices, garmentOf} from '@/files/to-garment.js';
import type {GarmentDocument, GarmentPiece} from '@/model/garment/garment-document.js';
import {plus, type Point} from '@/model/geometry/vectors.js';
import {atShare, signedArea} from '@/model/geometry/polyline.js';
import {dxfOf, habits, type Habits, type PatternPiece} from '../../support/files/dxf-habits.js';
import {cases, sampleOf} from '../../support/level.js';
import {drawnOutline} from '../../support/garments/panel-curves.js';
import {at, crossesItself, greatest, scale, toLine} from '../../support/plane.js';

const garments = ['tee-m', 'shirt-m', 'princess-dress-l', 'trousers-s'];

function patternOf(name: string): PatternPiece[] {
  const file = fileURLToPath(new URL(`../../../public/garments/${name}.json`, import.meta.url));
  const garment = JSON.parse(readFileSync(file, 'utf8')) as GarmentCodeSpecification;
  return Object.keys(garment.pattern.panels).map((panel) => {
    const edges = drawnOutline(garment, panel, false);
    return {name: panel, edges, notches: [atShare(at(edges, 0), 0.3).at]};
  });
}

const bytesOf = (text: string): Uint8Array => new TextEncoder().encode(text);

function imported(text: string): GarmentDocument {
  const drawing = readDrawing(bytesOf(text), 'pattern.dxf');
  // centimetres that nothing states may be inches
  expect(drawing.unit.isSure || drawing.unit.unit === 'cm').toBe(true);
  return garmentOf(drawing, defaultChoices(drawing));
}

const lineOf = ({outline}: GarmentPiece): Point[] =>
  outline.flatMap((edge) => edgeLine(edge, 128).slice(0, -1));

/** Greatest distance between two closed lines, in both directions. [cm] */
function apart(one: readonly Point[], other: readonly Point[]): number {
  const closed = (line: readonly Point[]): Point[] => [...line, at(line, 0)];
  return greatest([
    ...one.map((p) => toLine(p, closed(other))),
    ...other.map((p) => toLine(p, closed(one))),
  ]);
}

/** @param keyed  tolerance for the gaps between key points [cm] */
function check(pattern: readonly PatternPiece[], how: Habits, keyed: number): GarmentDocument {
  const garment = imported(dxfOf(pattern, how));
  const {pieces} = garment;
  expect(pieces).toHaveLength(pattern.length);
  pattern.forEach((piece, k) => {
    const line = lineOf(at(pieces, k));
    expect(signedArea(line)).toBeGreaterThan(0);
    expect(
      apart(
        line,
        piece.edges.flatMap((edge) => edge.slice(0, -1)),
      ),
    ).toBeLessThan(keyed);
  });
  return garment;
}

describe.each(Object.entries(habits))('a file as %s writes it', (_, how: Habits) => {
  it.each(sampleOf(1, garments))('shows %s as it was drafted', (garment) => {
    const pattern = patternOf(garment);
    const {pieces} = check(pattern, how, how.steps === undefined ? 0.01 : 0.09);
    if (how.blocks !== 'none') {
      expect(pieces.map(({name}) => name)).toEqual(pattern.map(({name}) => name));
      expect(pieces.map(({notches}) => notches?.length)).toEqual(pattern.map(() => 1));
    }
    if (how.turnPoints) {
      const drafted = pattern.map(({edges}) => edges.length);
      expect(pieces.map(({outline}) => outline.length)).toEqual(drafted);
    }
  });
});

const share = fc.integer({min: 0, max: 1000}).map((k) => k / 1000);

/** A piece with corners around a middle and some curved edges, 30 to 90 cm across. */
const randomPiece = fc
  .integer({min: 3, max: 7})
  .chain((count) => {
    const each = fc.array(share, {minLength: count, maxLength: count});
    return fc.record({
      count: fc.constant(count),
      radii: each,
      turns: each,
      bends: each,
      place: fc.tuple(share, share),
    });
  })
  .map(({count, radii, turns, bends, place}): PatternPiece => {
    const middle = scale([at(place, 0), at(place, 1)], 400);
    const corners = radii.map((radius, k) => {
      const angle = (2 * Math.PI * (k + 0.7 * at(turns, k))) / count;
      return plus(middle, scale([Math.cos(angle), Math.sin(angle)], 20 + 20 * radius));
    });
    const edges = corners.map((from, k) => {
      const to = at(corners, (k + 1) % count);
      const bend = at(bends, k) < 0.4 ? 0 : 0.3 * (at(bends, k) - 0.7);
      return Array.from({length: bend === 0 ? 2 : 81}, (_, j) => {
        const t = bend === 0 ? j : j / 80;
        const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
        const off = 4 * bend * t * (1 - t);
        return [from[0] + t * dx - off * dy, from[1] + t * dy + off * dx] as Point;
      });
    });
    return {name: 'piece', edges};
  })
  .filter(({edges}) => !crossesItself(edges.flatMap(sides)));

/** The straight parts of a line. */
const sides = (line: readonly Point[]): (readonly [Point, Point])[] =>
  line.slice(1).map((to, k) => [at(line, k), to]);

const randomHabits: fc.Arbitrary<Habits> = fc.record(
  {
    perCm: fc.constantFrom(10, 1),
    boundary: fc.constantFrom('flagged', 'repeated', 'unflagged', 'open', 'segments', 'light'),
    clockwise: fc.boolean(),
    turnPoints: fc.boolean(),
    check: fc.constantFrom('corners', 'dense'),
    blocks: fc.constantFrom('own', 'alike', 'none'),
    isMoved: fc.boolean(),
    lineEnd: fc.constantFrom('\n', '\r\n', '\r'),
    style: fc.constant(['Units: METRIC', 'Sample Size: M']),
  },
  {requiredKeys: ['perCm', 'boundary', 'blocks', 'style']},
);

it('reads whatever habits are combined', () => {
  fc.assert(
    fc.property(fc.array(randomPiece, {minLength: 1, maxLength: 3}), randomHabits, (drawn, how) => {
      const pattern = drawn.map((piece, k) => ({...piece, name: `piece ${k + 1}`}));
      // A flat file is read by layer 1 only if it has one; these files draw nothing else on layer
      // 0.
      check(
        pattern,
        how.boundary === 'light' && how.blocks !== 'none' ? {...how, boundary: 'flagged'} : how,
        0.01,
      );
    }),
    {numRuns: cases(20, 60)},
  );
});
