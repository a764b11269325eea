/** What would be suggested for a garment, also as if somebody had yet to sew it: as plain values, by names of pieces. */
import type {EdgeOfPiece, GarmentDocument} from '../model/garment-document.js';
import {rankPartners} from './rank.js';
import {sureSeams} from './suggest.js';

export interface SuggestionSettings {
  /** Takes the garment's seams away first. */
  readonly strip?: boolean;
  /** How many of them are left, chosen by chance; all if there are fewer. Default 0. */
  readonly confirm?: number;
  /** Same seed, same choice. Default 1. */
  readonly seed?: number;
}

export interface NamedEdge {
  readonly piece: string;
  /** Its number on the outline. */
  readonly edge: number;
}

export interface SeamSuggestions {
  /** Every edge that is not sewn yet, and what it may be sewn to, the likeliest first, ten at most. */
  readonly edges: readonly (NamedEdge & {
    readonly partners: readonly (NamedEdge & {
      /** How likely it is, from 0 to 1. */
      readonly p: number;
      /** Start meets start; otherwise the start of one edge meets the end of the other. */
      readonly turned: boolean;
    })[];
  })[];
  /** Seams that are as good as certain, the likeliest first. */
  readonly sure: readonly {readonly a: NamedEdge; readonly b: NamedEdge; readonly p: number}[];
}

const mostPartners = 10;

/** Whole numbers below a limit, each as likely as any other: Mulberry32. */
function chance(seed: number): (below: number) => number {
  let state = seed >>> 0;
  return (below) => {
    state = (state + 0x6d2b79f5) >>> 0;
    let mixed = Math.imul(state ^ (state >>> 15), 1 | state);
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed;
    return Math.floor((((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32) * below);
  };
}

/** The garment with so many of its seams, chosen by chance. */
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
