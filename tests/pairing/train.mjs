// Learns web/src/pairing/weights.ts from garments with known seams:
//   npm run build && node tests/pairing/train.mjs DESIGNS PATTERNS [--dry]
// DESIGNS is a folder of hundreds of garments, at any depth, in files named *specification.json;
// three of each kind at most are used. The weights in the repository were learned from the random designs of
// https://github.com/hackertehlike/GarmentCode-Nesting (MIT licence), folder
// nesting-assets/pattern_files, drafted with GarmentCode (M. Korosteleva, O. Sorkine-Hornung, MIT
// licence).
// PATTERNS is a folder of garments of another kind, *.json, each used four times: the 23 templates
// of https://github.com/maria-korosteleva/Garment-Pattern-Generator (MIT licence). The repository
// contains none of these files. The samples of the project are the third kind, each used four times.
// With 800 designs of the first kind alone, results were worse for patterns of the other kinds.
import {readdirSync, readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';

import {readGarment} from '../../dist/node/index.js';
import {believed, candidatesOf, givenBeliefs, hopeful} from '../../dist/pairing/candidates.js';
import {dartsOf} from '../../dist/pairing/darts.js';
import {measured} from '../../dist/pairing/edges.js';
import {surroundingsOf} from '../../dist/pairing/features.js';
import {mirrorEdges} from '../../dist/pairing/mirror-edges.js';
import {logOdds, unpacked} from '../../dist/pairing/network.js';
import {chance, Rows} from './network.mjs';

const [designs = '.', patterns = '.', ...flags] = process.argv.slice(2);
const mostDesigns = 520;
/** Greatest number of seams of a design, and of designs of one kind. */
const most = {seams: 70, alike: 3};
/** Number of uses of each sample and of each pattern. */
const uses = 4;
const random = chance(7);

/** Every tenth design is held back for later evaluation. */
const isHeldBack = (number) => number % 10 === 9;

const designFiles = readdirSync(designs, {recursive: true})
  .filter((name) => name.endsWith('specification.json') && name.includes('rand_'))
  .sort()
  .filter((_, number) => !isHeldBack(number));

function shuffled(list) {
  const left = [...list];
  return list.map(() => left.splice(Math.floor(random() * left.length), 1)[0]);
}

/** Reads a garment; undefined if an outline crosses itself. */
const readFile = (folder, file) =>
  readGarment(readFileSync(join(folder, file), 'utf8'), file).catch(() => undefined);

/** Some designs of each kind; the names of their pieces define the kind. */
async function readDesigns() {
  const kinds = new Map();
  const found = [];
  for (const file of shuffled(designFiles)) {
    if (found.length >= mostDesigns) break;
    const document = await readFile(designs, file);
    const kind = document?.pieces
      .map(({name}) => name.replaceAll(/\d+/g, ''))
      .sort()
      .join();
    const alike = kinds.get(kind) ?? 0;
    if (!document || document.seams.length > most.seams || alike >= most.alike) continue;
    kinds.set(kind, alike + 1);
    found.push(document);
  }
  return found;
}

async function readAll() {
  const samples = readdirSync('public/garments').filter((name) => /-(xs|m|xl)\.json$/.test(name));
  const smaller = samples.filter((name) => !/^patchwork-jacket-(xs|xl)/.test(name)); // forty pieces
  const repeated = (list) => Array.from({length: uses}, () => list).flat();
  const others = readdirSync(patterns).filter((name) => name.endsWith('.json'));
  const all = [
    ...(await readDesigns()),
    ...(await Promise.all(repeated(smaller).map((file) => readFile('public/garments', file)))),
    ...(await Promise.all(repeated(others).map((file) => readFile(patterns, file)))),
  ];
  return all.filter((document) => document !== undefined);
}

/**
 * The garment as other programs might write it: sometimes without names, with turned pieces, or
 * with each piece stretched by up to a percent, so that seams are eased.
 */
function varied({pieces, ...document}) {
  const [nameless, turned, eased] = [0.3, 0.15, 0.3].map((share) => random() < share);
  const byQuarters = random() < 0.5;
  const changed = pieces.map(({grain, ...piece}, number) => {
    const turn = byQuarters ? Math.floor(random() * 4) * (Math.PI / 2) : random() * 2 * Math.PI;
    const [c, s] = turned ? [Math.cos(turn), Math.sin(turn)] : [1, 0];
    const [sx, sy] = [0, 0].map(() => (eased ? 1 + 0.012 * (random() + random() - 1) : 1));
    const moved = ([x, y]) => [c * sx * x - s * sy * y, s * sx * x + c * sy * y];
    const outline = piece.outline.map((edge) => ({...edge, points: edge.points.map(moved)}));
    return {
      ...{...piece, outline, name: nameless ? `p${number}` : piece.name},
      ...(grain && !turned && {grain}),
    };
  });
  return {...document, pieces: changed};
}

/** Share of the garments whose seams are confirmed one by one, and not place by place. */
const oneByOne = 0.35;

/** Some of a garment's seams, chosen as in sewing: alike ones together, and all darts. */
function confirmedOf(garment, seams, all, share) {
  if (random() < oneByOne) return all.filter(() => random() < share);
  const stemOf = (piece) =>
    garment.pieces[piece].words.all.filter((word) => !/^(l|r|left|right)$/.test(word)).join(' ');
  const heights = (pair) =>
    pair
      .map((edge) => Math.round(3 * garment.edges[edge].place[1]))
      .sort()
      .join();
  const darts = new Set(share > 0 ? dartsOf(garment).map((pair) => [...pair].sort().join()) : []);
  const chosen = new Map();
  return all.filter((pair, k) => {
    if (darts.has([...pair].sort().join())) return true;
    const [one, other] = [seams[k].a.piece, seams[k].b.piece].map(stemOf).sort();
    const key = one === other ? `${one} ${heights(pair)}` : `${one} ${other}`;
    if (!chosen.has(key)) chosen.set(key, random() < share);
    return chosen.get(key);
  });
}

/** Pairs of a garment with some confirmed seams. */
function taskOf(document, confirmed, isTaken = () => true) {
  const {pieces, seams} = varied(document);
  const garment = measured(pieces);
  const numberOf = ({piece, edge}) => garment.pieces[piece].first + edge;
  const all = seams.map(({a, b}) => [numberOf(a), numberOf(b)]);
  const keyOf = ([i, j]) => Math.max(i, j) * garment.edges.length + Math.min(i, j);
  const sewn = confirmedOf(garment, seams, all, confirmed);
  const busy = new Set(sewn.flat());
  const truth = new Set(all.map(keyOf));
  const isSeam = (pair) => truth.has(keyOf(pair));
  const candidates = candidatesOf(surroundingsOf(garment, mirrorEdges(garment)), (i, j) => {
    if (busy.has(i) || busy.has(j)) return false;
    return isSeam([i, j]) || isTaken(garment.edges[i].length / garment.edges[j].length);
  });
  return {candidates, sewn, isSeam, weight: Math.sqrt(30 / (all.length + 1))};
}

/**
 * Learns the network without beliefs: all seams, half of the pairs of about equal lengths, few
 * others.
 */
function learnAlone(documents) {
  const share = (ratio) => (Math.abs(Math.log(ratio)) < 0.12 ? 0.5 : 0.06);
  const rows = new Rows();
  for (const document of documents) {
    const task = taskOf(document, 0, (ratio) => random() < share(ratio));
    const {candidates, isSeam, weight} = task;
    for (const [k, [i, j]] of candidates.pairs.entries()) {
      const {edges} = candidates.surroundings.garment;
      const sampled = isSeam([i, j]) ? 1 : share(edges[i].length / edges[j].length);
      rows.add(candidates.features[k], isSeam([i, j]), weight / sampled);
    }
  }
  console.log(`alone: ${rows.count} pairs`);
  return rows.learn({hidden: 16, epochs: 6, seed: 1});
}

/** Adds rows for the network given the beliefs of the networks so far, round after round. */
function addGiven(rows, documents, {alone, given, rounds}) {
  for (const document of documents) {
    const {
      candidates: all,
      sewn,
      isSeam,
      weight,
    } = taskOf(document, random() < 0.35 ? 0.001 : random() * 0.97);
    const first = all.features.map((features) => logOdds(alone, features));
    const candidates = hopeful(all, first);
    let beliefs = believed(all, first, sewn);
    for (let round = 0; ; round++) {
      const features = givenBeliefs(candidates, beliefs);
      if (round >= rounds.from) {
        for (const [k, pair] of candidates.pairs.entries()) {
          const likely = features[k][all.features[0].length] > -4;
          const sampled = isSeam(pair) || likely ? 1 : 0.15;
          if (random() < sampled) rows.add(features[k], isSeam(pair), weight / sampled);
        }
      }
      if (round === rounds.to) break;
      const odds = features.map((one) => logOdds(given, one));
      beliefs = believed(candidates, odds, sewn);
    }
  }
}

const documents = await readAll();
console.log(`${documents.length} garments`);
const alonePacked = learnAlone(documents);
const alone = unpacked(alonePacked);
const rows = new Rows();
addGiven(rows, documents, {alone, rounds: {from: 0, to: 0}});
console.log(`given: ${rows.count} pairs`);
const draft = unpacked(rows.learn({hidden: 24, epochs: 3, seed: 2}));
addGiven(rows, documents, {alone, given: draft, rounds: {from: 1, to: 2}});
console.log(`given: ${rows.count} pairs`);
const givenPacked = rows.learn({hidden: 24, epochs: 6, seed: 3});

const text = ({inputs, hidden, greatest, offset, text: digits}) =>
  `{inputs: ${inputs}, hidden: ${hidden}, greatest: [${greatest.map((one) => one.toPrecision(6)).join(', ')}],
  offset: ${offset.toPrecision(6)}, text: '${digits}'}`;
writeFileSync(
  flags.includes('--dry') ? 'build/weights.ts' : 'web/src/pairing/weights.ts',
  `/** What tests/pairing/train.mjs learned from ${documents.length} garments; its head says which. */
import type {PackedNetwork} from './network.js';

/** What a pair is by itself. */
export const alone: PackedNetwork = ${text(alonePacked)};

/** What it is given what is believed of all others. */
export const given: PackedNetwork = ${text(givenPacked)};
`,
);
