/**
 * Reports the suggested seams of a garment as plain values with names of pieces, optionally after
 * its seams are removed.
 */
import type {EdgeOfPiece, GarmentDocument} from '../model/garment/garment-document.js';
import {rankPartners} from './rank.js';
import {sureSeams} from './suggest.js';

export interface SuggestionSettings {
  /** Removes the garment's seams first. */
  readonly strip?: boolean;
  /** Number of random seams to keep after `strip`; all if there are fewer. Default 0. */
  readonly confirm?: number;
  /** Seed of the random choice. Default 1. */
  readonly seed?: number;
}

export interface NamedEdge {
  readonly piece: string;
  /** Number on the outline. */
  readonly edge: number;
}

export interface SeamSuggestions {
  /** Unsewn edges with their possible partners, the likeliest first, ten at most. */
  readonly edges: readonly (NamedEdge & {
    readonly partners: readonly (NamedEdge & {
      /** Likelihood, from 0 to 1. */
      readonly p: number;
      /** Start meets start; otherwise the start of one edge meets the end of the other. */
      readonly turned: boolean;
    })[];
  })[];
  /** Seams that are almost certain, the likeliest first. */
  readonly sure: readonly {readonly a: NamedEdge; readonly b: NamedEdge; readonly p: number}[];
}

const mostPartners = 10;

/** Returns a generator of uniform whole numbers below a limit: Mulberry32. */
function chance(seed: number): (below: number) => number {
  let state = seed >>> 0;
  return (below) => {
    state = (state + 0x6d2b79f5) >>> 0;
    let mixed = Math.imul(state ^ (state >>> 15), 1 | state);
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed;
    return Math.floor((((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32) * below);
  };
}

/** Returns the garment with `confirm` of its seams, chosen at random. */
function stripped(garment: GarmentDocument, confirm = 0, seed = 1): GarmentDocument {
  const below = chance(seed);
  const left = [...garment.seams];
  const kept = Array.from({length: Math.min(confirm, left.length)}, () =>
    left.splice(below(left.length), 1),
  );
  return {...garment, seams: kept.flat()};
}

export function suggestionsFor(
  garment: GarmentDocument,
  {strip = false, confirm = 0, seed = 1}: SuggestionSettings = {},
): SeamSuggestions {
  const sewn = strip ? stripped(garment, confirm, seed) : garment;
  const named = ({piece, edge}: EdgeOfPiece): NamedEdge => ({
    piece: sewn.pieces[piece]?.name ?? '',
    edge,
  });
  const all = sewn.pieces.flatMap(({outline}, piece) => outline.map((_, edge) => ({piece, edge})));
  return {
    edges: all.flatMap((edge) => {
      const partners = rankPartners(sewn, edge).slice(0, mostPartners);
      if (partners.length === 0) return [];
      const listed = partners.map(({edge: other, p, sameDirection}) => ({
        ...named(other),
        ...{p, turned: sameDirection},
      }));
      return [{...named(edge), partners: listed}];
    }),
    sure: sureSeams(sewn).map(({a, b, p}) => ({a: named(a), b: named(b), p})),
  };
}
