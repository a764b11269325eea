/** The checks of drapes must find every fault they are made for. */
import {describe, expect, it} from 'vitest';

import {drapeFile, drapeText, type DrapeFile, type Place} from '@/model/documents/drape-file.js';
import {apart, judgeDrape, unborne} from '../../support/drape/judge.js';
import {broken} from '../../support/drape/limits.js';
import {forcesOf} from '../../support/drape/energy.js';
import {at} from '../../support/plane.js';
import {SewnCloth} from '../../support/drape/sewn-cloth.js';
import {squaresDrape, squaresResult} from '../../support/drape/sewn-squares.js';
import {plus3} from '../../support/drape/space.js';

const sound = drapeFile(squaresResult, squaresDrape());

/** Moves the positions of all pieces. */
const placed = (to: (place: Place, piece: number) => Place, file = sound): DrapeFile => ({
  ...file,
  pieces: file.pieces.map((piece, k) => ({
    ...piece,
    positions: piece.positions.map((place) => to(place, k)),
  })),
});

/** Moves one vertex of one piece. */
const oneMoved = (piece: number, vertex: number, by: Place): DrapeFile => ({
  ...sound,
  pieces: sound.pieces.map((one, k) => ({
    ...one,
    positions: one.positions.map((place, v): Place => {
      if (k !== piece || v !== vertex) return place;
      return [place[0] + by[0], place[1] + by[1], place[2] + by[2]];
    }),
  })),
});

const sentences = (file: DrapeFile, result = squaresResult) => broken(judgeDrape(file, result));

const pieceChanged = (piece: number, change: object): DrapeFile => ({
  ...sound,
  pieces: sound.pieces.map((one, k) => (k === piece ? {...one, ...change} : one)),
});

it('finds nothing wrong with a sound drape', () => {
  const verdict = judgeDrape(sound, squaresResult);
  expect(broken(verdict)).toEqual([]);
  expect(verdict).toMatchObject({gap: 0, depth: 0, clear: 1, crossings: 0, asymmetry: 0});
  expect(verdict.tension.max).toBeLessThan(1e-12);
  expect(verdict.lowest).toBe(100);
  expect(verdict.energies.weight).toBeCloseTo(0.12 * 9.81 * 32e-4 * 1.02, 12);
});

it('writes numbers that mirror each other as such, and the same text for the same drape', () => {
  const drape = squaresDrape();
  const uneven = Float64Array.from(drape.positions, (value, k) =>
    k % 3 === 0 ? value + 0.00005 * Math.sign(value) : value,
  );
  const file = drapeFile(squaresResult, {...drape, positions: uneven});
  expect(judgeDrape(file, squaresResult).asymmetry).toBe(0);
  expect(drapeText(file)).toBe(drapeText(drapeFile(squaresResult, {...drape, positions: uneven})));
  expect(drapeText(file)).not.toContain('-0,');
});

describe('finds', () => {
  it('a seam that gapes', () => {
    const file = oneMoved(1, 10, [0, 0, 0.001]); // a vertex on the second piece's seam
    expect(judgeDrape(file, squaresResult).gap).toBeCloseTo(0.001, 9);
    expect(sentences(file).join()).toContain('seams gape by');
  });

  it('cloth in the form, however deep, and cloth that touches it', () => {
    const into = placed(([x, y]) => [x, y, 4.9]);
    expect(judgeDrape(into, squaresResult).depth).toBeCloseTo(0.1, 9);
    expect(sentences(into).join()).toContain('deep in the form');
    const through = placed(([x, y]) => [x, y, 0]);
    expect(judgeDrape(through, squaresResult).depth).toBe(1); // the checks measure no deeper
    const near = placed(([x, y]) => [x, y, 5.02]);
    expect(sentences(near)).toEqual(['only 0.00 % of it are 0.5 mm off the form']);
    // only the middles of triangles: a spike of the form between vertices
    const {vertices, triangles} = sound.form;
    const [x, y, tip] = [-5 / 3, 101 + 2 / 3, vertices.length];
    const spike = {
      vertices: [
        ...vertices,
        ...([
          [x - 0.2, y - 0.2, 7],
          [x + 0.2, y - 0.2, 7],
          [x, y + 0.2, 7],
          [x, y, 8.5],
        ] as const),
      ],
      triangles: [
        ...triangles,
        ...([
          [tip, tip + 2, tip + 1],
          [tip, tip + 1, tip + 3],
          [tip + 1, tip + 2, tip + 3],
          [tip + 2, tip, tip + 3],
        ] as const),
      ],
    };
    const pricked = {...sound, form: {...sound.form, ...spike}};
    expect(judgeDrape(pricked, squaresResult).depth).toBeGreaterThan(0.02);
  });

  it('a form that is not closed', () => {
    const file = {...sound, form: {...sound.form, triangles: sound.form.triangles.slice(1)}};
    expect(sentences(file)).toEqual(["the form's surface has 3 edges that are open"]);
  });

  it('cloth that is stretched, or pressed together, along any direction', () => {
    const wide = judgeDrape(
      placed(([x, y, z]) => [1.06 * x, y, z]),
      squaresResult,
    );
    for (const share of [wide.tension.median, wide.tension.max]) expect(share).toBeCloseTo(0.06, 9);
    expect(wide.compression.max).toBeCloseTo(0, 9);
    expect(broken(wide).join()).toContain('half of it is stretched by 6.00 %');
    // sheared by 0.2: the stretches are those of [[1, 0.2], [0, 1]]
    const sheared = judgeDrape(
      placed(([x, y, z]) => [x + 0.2 * (y - 100), y, z]),
      squaresResult,
    );
    expect(sheared.tension.max).toBeCloseTo(Math.sqrt(1.01) + 0.1 - 1, 9);
    expect(sheared.compression.max).toBeCloseTo(1 - Math.sqrt(1.01) + 0.1, 9);
    const short = placed(([x, y, z]) => [x, 100 + 0.88 * (y - 100), z]);
    expect(sentences(short).join()).toContain('compressed by 12.00 %');
  });

  it('but lets cloth be pressed together beside gathers', () => {
    const short = placed(([x, y, z]) => [x, 100 + 0.88 * (y - 100), z]);
    const [seam] = squaresResult.seams;
    const gathers = {...squaresResult, seams: [{...at([seam], 0), lengthRatio: 1.5}]} as const;
    const verdict = judgeDrape(short, gathers as typeof squaresResult);
    expect(verdict.compression.max).toBeCloseTo(0.12, 9);
    expect(verdict.flatCompression.max).toBe(0);
  });

  it('seams that are not as long as cut', () => {
    const file = placed(([x, y, z]) => [x, 100 + 0.97 * (y - 100), z]);
    expect(judgeDrape(file, squaresResult).sewnLength.p99).toBeCloseTo(0.03, 9);
    expect(sentences(file).join()).toContain('seams differ by 3.00 %');
  });

  it('a side that is not the mirror image of the other', () => {
    const file = oneMoved(0, 6, [0, 0, 0.001]);
    expect(judgeDrape(file, squaresResult).asymmetry).toBeCloseTo(0.001, 9);
    expect(sentences(file).join()).toContain('from its mirror image');
  });

  it('energies that rise, and one that is not that of the places', () => {
    const last = at(sound.stages, -1);
    const rising = {...sound, stages: [{...last, energy: [0.001, ...last.energy]}]};
    expect(sentences(rising).join()).toContain(
      "the stage 'settle' ends with more energy than it begins with",
    );
    const more = {...last, energy: last.energy.map((value) => 1.1 * value)};
    const higher = {...sound, stages: [last, more]};
    expect(sentences(higher).join()).toContain("the stage 'settle' ends with more energy than");
    expect(sentences({...sound, stages: [more]}).join()).toContain('10.00 % from what the file');
    const nothing = {...sound, stages: [{...last, energy: []}]};
    expect(sentences(nothing).join()).toContain('NaN');
  });

  it('edges that pass through triangles', () => {
    // the second square folded back along the seam, and through the first one
    const folded = placed(([x, y, z], piece): Place => {
      return piece === 0 ? [x, y, z] : [-x, y + 0.3, z + 0.5 * x * (x - 2.5)];
    });
    const verdict = judgeDrape(folded, squaresResult);
    expect(verdict.crossings).toBeGreaterThan(0);
    expect(broken(verdict).join()).toContain('edges cross triangles');
    // two layers over the same place without contact
    const layers = placed(([x, y, z], piece) => (piece === 0 ? [x, y, z] : [-x, y, z + 0.1 * x]));
    expect(judgeDrape(layers, squaresResult).crossings).toBe(0);
  });

  it('a hem below the floor, and a waist that has slipped', () => {
    const below = placed(([x, y, z]) => [x, y - 101, z]);
    expect(sentences(below).join()).toContain('it reaches 1 cm below the floor');
    expect(judgeDrape(below, squaresResult).waist).toBeLessThan(-90);
    expect(sentences(placed(([x, y, z]) => [x, y + 12, z])).join()).not.toContain('waist');
  });

  it('pieces and seams that are not those of the result', () => {
    const {shape, positions} = at(sound.pieces, 0);
    const other = (change: object) => sentences(pieceChanged(0, change)).join();
    expect(other({name: 'sleeve'})).toContain("the result calls 'sleeve' 'right'");
    const shrunk = shape.map(([x, y]) => [0.99 * x, y]);
    expect(other({shape: shrunk})).toContain("the outline of 'right' is 0.04");
    const nowhere = positions.map(() => [NaN, NaN, NaN]);
    expect(other({positions: nowhere})).toContain("a place of 'right' is none");
    const turned = at(sound.pieces, 0).triangles.map(([a, b, c]) => [a, c, b]);
    expect(other({triangles: turned})).toContain('turned over');
    const {a, b} = at(sound.seams, 0);
    const wrong = {...b, vertices: b.vertices.toReversed()};
    const twisted = sentences({...sound, seams: [{a, b: wrong, stitch: 0}]}).join();
    expect(twisted).toContain('side b of seam 0 is another line in the result');
    const shorter = {...a, vertices: a.vertices.slice(1)};
    const cut = sentences({...sound, seams: [{a: shorter, b, stitch: 0}]}).join();
    expect(cut).toContain('the sides of seam 0 differ');
    expect(sentences({...sound, seams: []}).join()).toContain('other seams in the result');
  });
});

it('says how far apart two drapes lie', () => {
  expect(apart(sound, sound)).toEqual({rms: 0, max: 0});
  const moved = placed(([x, y, z], piece) => (piece === 0 ? [x + 3, y, z + 4] : [x, y, z]));
  expect(apart(sound, moved).max).toBeCloseTo(5, 12);
  expect(apart(sound, moved).rms).toBeCloseTo(5 / Math.SQRT2, 12);
});

it('says how much of the weight hangs on nothing', () => {
  expect(unborne(sound, squaresResult)).toBeCloseTo(1, 9); // clear of the form, at rest lengths
  const touching = placed(([x, y]) => [x, y, 5.1]);
  expect(unborne(touching, squaresResult)).toBe(0);
});

it('reckons forces as the slope of the energy', () => {
  const isMoved = ([x, y]: Place) => x < -0.1 && y < 97.5;
  for (const lengthRatio of [1, 1.5]) {
    const seams = squaresResult.seams.map((seam) => ({...seam, lengthRatio}));
    const result = {...squaresResult, seams};
    const bent = placed(([x, y, z]): Place => [1.05 * x, 0.97 * y, z + 0.1 * (y - 100) * x]);
    const moved = (by: Place) => placed((place) => plus3(place, by, isMoved(place) ? 1 : 0), bent);
    const energy = (by: Place) => {
      const {membrane, bending, weight} = judgeDrape(moved(by), result).energies;
      return membrane + bending + weight;
    };
    const cloth = new SewnCloth(bent);
    const forces = forcesOf({file: bent, ratios: [lengthRatio]}, cloth);
    const lower = new Set(
      at(bent.pieces, 0).positions.flatMap((place, vertex) =>
        isMoved(place) ? [cloth.vertex(0, vertex)] : [],
      ),
    );
    for (const axis of [0, 1, 2] as const) {
      const by = [0, 1, 2].map((k) => (k === axis ? 1e-4 : 0)) as unknown as Place;
      const slope = (energy(by) - energy(plus3([0, 0, 0], by, -1))) / 2e-6; // J/m
      let force = 0;
      for (const vertex of lower) {
        const {pull, weight} = forces.get(vertex) ?? {pull: [NaN, NaN, NaN], weight: NaN};
        force += pull[axis] - (axis === 1 ? weight : 0);
      }
      expect(-slope).toBeCloseTo(force, 5);
    }
  }
});
