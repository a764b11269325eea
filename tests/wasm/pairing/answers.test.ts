/**
 * Garments sewn by *yes* to every question: samples without their seams, and the same as DXF. Name
 * other garments with seams in the variable GARMENTS, separated by spaces, to print their figures.
 */
import {readdirSync, readFileSync} from 'node:fs';
import {basename} from 'node:path';

import {readGarment} from 'seamwise/node';
import {expect, it} from 'vitest';

import {readDrawing} from '@/files/read-drawing.js';
import {defaultChoices, garmentOf} from '@/files/to-garment.js';
import {edgeLine} from '@/model/garment/edge-curve.js';
import {atShare} from '@/model/geometry/polyline.js';
import {foldLines} from '@/model/garment/folds.js';
import type {GarmentDocument} from '@/model/garment/garment-document.js';
import {dxfOf, habits, type PatternPiece} from '../../support/files/dxf-habits.js';
import {isThorough} from '../../support/level.js';
import {scoreOf, sewnByYes, type Score} from '../../pairing/answers.js';

/** Forty pieces of a patchwork take a minute, and the ends of a neck strap are scraps. */
const others = /^(patchwork-jacket|apron)/;
/** A commit takes a garment with sleeves, one of folds, and one of gathers. */
const sampled = /^(tee|box-pleated-skirt|gathered-skirt)-m/;
const samples = readdirSync('public/garments')
  .filter((name) =>
    isThorough ? name.endsWith('-m.json') && !others.test(name) : sampled.test(name),
  )
  .map((name) => `public/garments/${name}`);
const read = (file: string): Promise<GarmentDocument> =>
  readGarment(readFileSync(file, 'utf8'), file);

const patternOf = ({pieces}: GarmentDocument): readonly PatternPiece[] =>
  pieces.map(({name, outline, grain, notches = [], folds = []}) => {
    const edges = outline.map((edge) => edgeLine(edge, 60));
    return {
      ...{name, edges, ...(grain?.line && {grain: grain.line})},
      notches: notches.map(({edge, at}) => atShare(edges[edge] ?? [], at).at),
      labelled: folds.flatMap((fold) =>
        foldLines(fold).map((line) => ({line, text: `${fold.kind} pleat`})),
      ),
    };
  });

function asDxf(garment: GarmentDocument, program: keyof typeof habits): GarmentDocument {
  const text = dxfOf(patternOf(garment), habits[program]);
  const drawing = readDrawing(new TextEncoder().encode(text), 'pattern.dxf');
  return garmentOf(drawing, defaultChoices(drawing));
}

interface Figures extends Score {
  readonly questions: number;
}

function figuresOf(truth: GarmentDocument, bare: GarmentDocument): Figures {
  const {garment, questions} = sewnByYes(bare);
  return {...scoreOf(truth, garment), questions: questions.length};
}

const ways = {
  'as it is': (garment: GarmentDocument) => garment,
  'as Gerber writes it': (garment: GarmentDocument) => asDxf(garment, 'gerber'),
};

it.each(Object.entries(ways))('finds nearly all seams of the samples, %s', async (_, way) => {
  const all = await Promise.all(
    samples.map(async (file) => {
      const truth = await read(file);
      return {file, ...figuresOf(truth, way(truth))};
    }),
  );
  for (const {file, found, twice, questions} of all) {
    expect(found, file).toBeGreaterThan(0.95);
    expect(twice, file).toBe(0);
    expect(questions, file).toBeLessThanOrEqual(12);
  }
  expect(all.flatMap(({wrong}) => wrong).length).toBeLessThanOrEqual(isThorough ? 3 : 0);
});

const named = process.env.GARMENTS?.split(' ') ?? [];
it.runIf(named.length > 0)('prints figures of other garments', async () => {
  const rows = await Promise.all(
    named.map(async (file) => {
      const truth = await read(file);
      const {questions, found, wrong, twice} = figuresOf(truth, asDxf(truth, 'gerber'));
      return {garment: basename(file), questions, found, wrong: wrong.length, twice};
    }),
  );
  console.table(rows);
});
