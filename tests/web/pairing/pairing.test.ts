import {describe, expect, it} from 'vitest';

import type {EdgeOfPiece, GarmentDocument, GarmentPiece} from '@/model/garment/garment-document.js';
import type {Point} from '@/model/geometry/vectors.js';
import {measured} from '@/pairing/edges.js';
import {mirrorImage} from '@/pairing/image.js';
import {rankPartners} from '@/pairing/rank.js';
import {suggestionsFor} from '@/pairing/report.js';
import {likeliestSides} from '@/pairing/sides.js';
import {likeliestSeams, sureSeams} from '@/pairing/suggest.js';
import {isPlain} from '@/pairing/sure.js';

import {
  documentOf,
  draftedPolygon,
  draftedRectangle,
  draftedSeam,
} from '../../support/garments/documents.js';
import {shirtWithSleeves} from '../../support/garments/shirts.js';

/** A skirt of two trapezes with a waistband of two strips. */
const skirt = (): GarmentDocument => {
  const panel: readonly Point[] = [
    [-30, 0],
    [30, 0],
    [20, 60],
    [-20, 60],
  ];
  const band = (name: string) => draftedRectangle(name, 40, 4);
  const pieces = [
    draftedPolygon('front', panel),
    draftedPolygon('back', panel),
    band('band_front'),
    band('band_back'),
  ];
  const seam = (a: readonly [number, number], b: readonly [number, number]) =>
    draftedSeam({a: {piece: a[0], edge: a[1]}, b: {piece: b[0], edge: b[1]}});
  return documentOf(pieces, {
    seams: [
      seam([0, 1], [1, 3]),
      seam([0, 3], [1, 1]),
      seam([0, 2], [2, 0]),
      seam([1, 2], [3, 0]),
      seam([2, 1], [3, 3]),
      seam([2, 3], [3, 1]),
    ],
  });
};

const bare = (garment: GarmentDocument): GarmentDocument => ({...garment, seams: []});

/** All likelihoods by names that a change of the garment keeps. */
function likelihoods(
  garment: GarmentDocument,
  nameOf = (number: number, edge: number) =>
    `${garment.pieces[number]?.name ?? ''} ${String(edge)}`,
): Map<string, number> {
  const all = new Map<string, number>();
  for (const [number, {outline}] of garment.pieces.entries()) {
    for (const edge of outline.keys()) {
      for (const partner of rankPartners(garment, {piece: number, edge})) {
        const other = nameOf(partner.edge.piece, partner.edge.edge);
        all.set(`${nameOf(number, edge)} - ${other}`, partner.p);
      }
    }
  }
  return all;
}

function expectAlike(one: Map<string, number>, other: Map<string, number>): void {
  expect(one.size).toBeGreaterThan(20);
  expect([...other.keys()].sort()).toEqual([...one.keys()].sort());
  for (const [pair, p] of one)
    expect(Math.abs(p - (other.get(pair) ?? -1)), pair).toBeLessThan(1e-6);
}

describe('rankPartners', () => {
  it('puts the seams of a skirt among the first three', () => {
    const garment = skirt();
    for (const {a, b} of garment.seams) {
      for (const [edge, mate] of [
        [a, b],
        [b, a],
      ] as const) {
        const best = rankPartners(bare(garment), edge).slice(0, 3);
        expect(best.map((partner) => partner.edge)).toContainEqual(mate);
      }
    }
  });

  it('gives likelihoods that add up to one at most, the same both ways, and falling', () => {
    const garment = bare(skirt());
    const all = likelihoods(garment);
    for (const [pair, p] of all) {
      const [a = '', b = ''] = pair.split(' - ');
      expect(all.get(`${b} - ${a}`)).toBe(p);
      expect(p).toBeGreaterThan(0);
    }
    const ps = rankPartners(garment, {piece: 0, edge: 1}).map(({p}) => p);
    expect(ps).toEqual(ps.toSorted((a, b) => b - a));
    expect(ps.reduce((sum, p) => sum + p, 0)).toBeLessThan(1.0001);
  });

  it('sews a tube to itself', () => {
    const garment = documentOf([draftedRectangle('sleeve', 22, 50)]);
    const [best] = rankPartners(garment, {piece: 0, edge: 1});
    expect(best?.edge).toEqual({piece: 0, edge: 3});
    expect(best?.sameDirection).toBe(false);
  });

  it('asks nobody about edges that are sewn or stay open', () => {
    const garment = skirt();
    const [first, ...others] = garment.seams;
    if (!first) throw new Error('no seam');
    const sewn = {...garment, seams: [first]};
    expect(rankPartners(sewn, first.a)).toEqual([]);
    const partners = others.flatMap(({a}) => rankPartners(sewn, a).map(({edge}) => edge));
    expect(partners).not.toContainEqual(first.a);
    expect(partners).not.toContainEqual(first.b);

    const [front, ...rest] = bare(garment).pieces;
    if (!front) throw new Error('no piece');
    const outline = front.outline.map((edge, k) =>
      k === 0 ? {...edge, open: true as const} : edge,
    );
    const hemmed = {...bare(garment), pieces: [{...front, outline}, ...rest]};
    expect(rankPartners(bare(garment), {piece: 0, edge: 0}).length).toBeGreaterThan(0);
    expect(rankPartners(hemmed, {piece: 0, edge: 0})).toEqual([]);
  });

  it('takes no for an answer', () => {
    const garment = bare(skirt());
    const edge = {piece: 0, edge: 1};
    const [best] = rankPartners(garment, edge);
    if (!best) throw new Error('no partner');
    const others = rankPartners(garment, edge, {refused: [[best.edge, edge]]});
    expect(others.length).toBeGreaterThan(0);
    expect(others.map((one) => one.edge)).not.toContainEqual(best.edge);
  });

  it('lets starts meet where what is sewn of both pieces does', () => {
    const garment = skirt();
    const turned = {
      ...garment,
      seams: garment.seams.slice(0, 1).map((seam) => ({...seam, sameDirection: true})),
    };
    const partners = rankPartners(turned, {piece: 0, edge: 3});
    const between = partners.filter(({edge}) => edge.piece === 1);
    expect(between.length).toBeGreaterThan(0);
    for (const partner of partners) expect(partner.sameDirection).toBe(partner.edge.piece === 1);
  });
});

describe('what changes nothing', () => {
  const garment = bare(skirt());

  it('other names with the same words', () => {
    const renamed = garment.pieces.map((one) => ({
      ...one,
      name: one.name.replace('band', 'waistband'),
    }));
    const nameOf = (number: number, edge: number) =>
      `${garment.pieces[number]?.name ?? ''} ${String(edge)}`;
    expectAlike(likelihoods(garment), likelihoods({...garment, pieces: renamed}, nameOf));
  });

  it('another order of pieces, and of edges', () => {
    const turned = garment.pieces.map((one) => ({
      ...one,
      outline: [...one.outline.slice(1), ...one.outline.slice(0, 1)],
    }));
    const pieces = turned.toReversed();
    const nameOf = (number: number, edge: number) =>
      `${pieces[number]?.name ?? ''} ${String((edge + 1) % 4)}`;
    expectAlike(likelihoods(garment), likelihoods({...garment, pieces}, nameOf));
  });

  it('the scale', () => {
    const pieces = garment.pieces.map((one) => ({
      ...one,
      outline: one.outline.map(({points: [from, to]}) => ({
        points: [from, to].map(([x, y]): Point => [2.54 * x, 2.54 * y]) as [Point, Point],
      })),
    }));
    expectAlike(likelihoods(garment), likelihoods({...garment, pieces}));
  });

  it('a mirror', () => {
    const pieces = garment.pieces.map((one) => ({
      ...one,
      outline: one.outline.toReversed().map(({points: [from, to]}) => ({
        points: [to, from].map(([x, y]): Point => [0 - x, y]) as [Point, Point],
      })),
    }));
    const nameOf = (number: number, edge: number) =>
      `${pieces[number]?.name ?? ''} ${String(3 - edge)}`;
    expectAlike(likelihoods(garment), likelihoods({...garment, pieces}, nameOf));
  });
});

describe('what is suggested', () => {
  it('sews each edge once, the likeliest first', () => {
    const seams = likeliestSeams(bare(skirt()), 0.1);
    const ends = seams
      .flatMap(({a, b}) => [a, b])
      .map(({piece, edge}) => `${String(piece)} ${String(edge)}`);
    expect(ends.length).toBeGreaterThan(4);
    expect(new Set(ends).size).toBe(ends.length);
    const ps = seams.map(({p}) => p);
    expect(ps).toEqual(ps.toSorted((a, b) => b - a));
  });

  it('is sure of what is left when all else is sewn', () => {
    const garment = skirt();
    for (const [k, {a, b}] of garment.seams.entries()) {
      const [best] = rankPartners(
        {...garment, seams: garment.seams.filter((_, other) => other !== k)},
        a,
      );
      expect(best?.edge).toEqual(b);
    }
    const [last, ...sewn] = garment.seams;
    const left = sureSeams({...garment, seams: sewn});
    expect(left.map(({a, b}) => ({a, b}))).toEqual([{a: last?.a, b: last?.b}]);
  });

  it('knows the mirror image of an edge, on its piece or on the twin', () => {
    const garment = skirt();
    expect(mirrorImage(garment, {piece: 0, edge: 1})).toEqual({piece: 0, edge: 3});
    expect(mirrorImage(garment, {piece: 0, edge: 0})).toEqual({piece: 0, edge: 0});
    const corners: readonly Point[] = [
      [0, 0],
      [20, 0],
      [12, 30],
    ];
    const left = draftedPolygon('left front', corners);
    const right = draftedPolygon(
      'right front',
      corners.map(([x, y]): Point => [0 - x, y]).toReversed(),
    );
    expect(mirrorImage(documentOf([left, right]), {piece: 0, edge: 0})).toEqual({
      piece: 1,
      edge: 1,
    });
    expect(mirrorImage(documentOf([left]), {piece: 0, edge: 0})).toBeUndefined();
  });

  it('lists partners by name, for edges that are not confirmed', () => {
    const garment = skirt();
    const all = suggestionsFor(garment, {strip: true});
    expect(all.edges).toHaveLength(16);
    const half = suggestionsFor(garment, {strip: true, confirm: 3, seed: 5});
    expect(half.edges).toHaveLength(10);
    expect(half).toEqual(suggestionsFor(garment, {strip: true, confirm: 3, seed: 5}));
    const others = [1, 2, 3, 4].map((seed) =>
      suggestionsFor(garment, {strip: true, confirm: 3, seed}),
    );
    expect(new Set(others.map((one) => JSON.stringify(one))).size).toBeGreaterThan(1);
    for (const {partners} of half.edges) {
      expect(partners.length).toBeLessThanOrEqual(10);
      for (const {piece: name} of partners) {
        expect(garment.pieces.map((one) => one.name)).toContain(name);
      }
    }
    expect(suggestionsFor(garment, {strip: true, confirm: 99}).edges).toHaveLength(4);
  });

  it('says nothing of a garment without edges', () => {
    expect(suggestionsFor(documentOf([]))).toEqual({edges: [], sure: []});
  });
});

/**
 * A shirt with two sleeves of one piece: the armholes of front and back together are as long as a
 * cap.
 */
const shirt = shirtWithSleeves();
const at = (name: string, edge: number, garment = shirt): EdgeOfPiece => ({
  piece: garment.pieces.findIndex((one) => one.name === name),
  edge,
});

describe('a sleeve of one piece', () => {
  it('is closed by its own underarm, not by the other sleeve', () => {
    for (const name of ['sleeve', 'sleeve 2']) {
      const [best, ...others] = rankPartners(shirt, at(name, 1));
      expect(best?.edge).toEqual(at(name, 3));
      expect(best?.p).toBeGreaterThan(0.5);
      const pieces = [best, ...others].map((one) => shirt.pieces[one?.edge.piece ?? -1]?.name);
      expect(pieces.filter((other) => other?.startsWith('sleeve'))).not.toContain(
        name === 'sleeve' ? 'sleeve 2' : 'sleeve',
      );
    }
  });

  it('so is one whose twin is its mirror image', () => {
    const mirrored = shirtWithSleeves({isLopsided: true});
    expect(mirrorImage(mirrored, at('sleeve', 1, mirrored))).toEqual(at('sleeve 2', 3, mirrored));
    const [best] = rankPartners(mirrored, at('sleeve', 1, mirrored));
    expect(best?.edge).toEqual(at('sleeve', 3, mirrored));
    const seams = likeliestSeams(mirrored, 0.05);
    const names = seams.map(({a, b}) => [a, b].map(({piece: k}) => mirrored.pieces[k]?.name));
    expect(names).not.toContainEqual(['sleeve', 'sleeve 2']);
  });

  it('is set into both armholes, which go on at the shoulder', () => {
    const sides = likeliestSides(shirt).filter(({p}) => p > 0.15);
    const caps = sides.map(({edge, side}) => [edge, ...side]);
    expect(caps).toHaveLength(4); // each sleeve at either side
    expect(caps).toContainEqual([at('sleeve', 2), at('front', 2), at('back', 6)]);
    expect(caps).toContainEqual([at('sleeve 2', 2), at('back', 2), at('front', 6)]);
  });

  it('in the language of the file as well', () => {
    const german = {
      ...shirt,
      pieces: shirt.pieces.map((one) => ({...one, name: one.name.replace('sleeve', 'Ärmel')})),
    };
    const [best] = rankPartners(german, at('Ärmel', 1, german));
    expect(best?.edge).toEqual(at('Ärmel', 3, german));
  });
});

describe('what is sure', () => {
  /**
   * Returns whether no feature contradicts a seam between an edge of one piece and one of another.
   */
  const isPlainBetween = (
    one: GarmentPiece,
    a: number,
    other: GarmentPiece,
    b: number,
  ): boolean => {
    const document = documentOf([one, other]);
    const {edges, ...garment} = measured(document.pieces);
    const [first, second] = [edges[a], edges[one.outline.length + b]];
    if (!first || !second) throw new Error('no such edge');
    return isPlain(document, {...garment, edges}, first, second);
  };
  const across = (name: string, width: number) => draftedRectangle(name, width, 40);

  it('is as long as what it is sewn to, unless names say gathers', () => {
    expect(isPlainBetween(across('front', 30), 2, across('back', 31), 0)).toBe(true);
    expect(isPlainBetween(across('front', 24.4), 2, across('back', 36.4), 0)).toBe(false);
    expect(isPlainBetween(across('bodice', 24), 2, across('skirt', 30), 0)).toBe(true);
    expect(isPlainBetween(across('sleeve', 24), 0, across('cuff', 20), 2)).toBe(true);
    expect(isPlainBetween(across('skirt', 24), 2, across('skirt_2', 30), 0)).toBe(false);
    expect(isPlainBetween(across('bodice', 4.6), 2, across('skirt', 9.6), 0)).toBe(false);
  });

  it('is no scrap', () => {
    expect(isPlainBetween(across('front', 2.5), 2, across('back', 2.5), 0)).toBe(true);
    expect(isPlainBetween(across('front', 1.1), 2, across('back', 1.1), 0)).toBe(false);
  });

  it('joins no right half of a back with a left one', () => {
    const halved = (name: string) =>
      draftedPolygon(name, [
        [-20, 0],
        [0, 0],
        [20, 0],
        [20, 10],
        [-20, 10],
      ]);
    // face up, the wearer's left is on the left of a back, on the right of a front
    expect(isPlainBetween(halved('back_skirt'), 0, across('left_back', 20), 2)).toBe(true);
    expect(isPlainBetween(halved('back_skirt'), 1, across('left_back', 20), 2)).toBe(false);
    expect(isPlainBetween(halved('front_skirt'), 1, across('left_front', 20), 2)).toBe(true);
    expect(isPlainBetween(halved('front_skirt'), 0, across('left_front', 20), 2)).toBe(false);
    // a centre seam joins both halves
    expect(isPlainBetween(across('right_back', 20), 1, across('left_back', 20), 3)).toBe(true);
  });

  it('is not what was refused', () => {
    const [first] = sureSeams(shirt);
    if (!first) throw new Error('nothing is sure');
    const left = sureSeams(shirt, {refused: [[first.b, first.a]]});
    const pairs = left.map(({a, b}) => [a, b]);
    expect(pairs).not.toContainEqual([first.a, first.b]);
  });
});

it('knows the images of what mirrors in part: the other side has one edge more', () => {
  const outline: readonly Point[] = [
    [0, 0],
    [25, 0],
    [27, 30],
    [14, 42],
    [0, 38],
  ];
  const mirrored = outline.map(([x, y]): Point => [0 - x, y]).toReversed();
  const [first, ...rest] = mirrored;
  if (!first) throw new Error('no corner');
  // an additional corner where a dart was moved
  const left = draftedPolygon('left_back', outline);
  const right = draftedPolygon('right_back', [
    ...rest.slice(0, 3),
    [-11, -1],
    ...rest.slice(3),
    first,
  ]);
  const garment = documentOf([left, right]);
  const images = [0, 1, 2, 3, 4].map((edge) => mirrorImage(garment, {piece: 0, edge}));
  expect(images.filter((image) => image?.piece === 1).length).toBe(4);
  for (const [edge, image] of images.entries()) {
    if (!image) continue;
    expect(mirrorImage(garment, image)).toEqual({piece: 0, edge});
  }
});
