// Layouts on printed fabric: length, distance to the lower bound, time.
import {readFileSync} from 'node:fs';

import {chance} from '../pairing/network.mjs';
import {both, isThere, unlessBroken, usualOf} from './parts.mjs';

/** Garments of 4 to 12 pieces, from wide to long ones. */
const usualNames = ['tee', 'shirt', 'trousers', 'princess-dress', 'hoodie'];
/** Sides of the print's cell, a square. [cm] */
const repeats = [10, 20];
/** Usable width of the fabric, and allowance around the pieces. [cm] */
const width = 140;
const allowanceCm = 1;

/**
 * Lays out garments on fabric with and without a print of group p2. Alignments are random, which is
 * harder than those of solved garments, as these repeat.
 */
export async function measureLayouts({programs, garments, prints, seeds, thorough, say, fail}) {
  const [print] = prints.layouts;
  const rows = [];
  for (const garment of usualOf(garments, thorough, usualNames)) {
    const outlines = await unlessBroken(`layouts: ${garment.name}`, fail, () =>
      cutOutlines(garment, print),
    );
    for (const {repeat, seed} of outlines ? cases(seeds) : []) {
      const name = `${garment.name}, ${repeat} cm${seed > 1 ? ` (seed ${seed})` : ''}`;
      say(`layouts: ${name}`);
      const measure = () => measureCase(programs, outlines, {group: print.group, repeat, seed});
      const row = await unlessBroken(`layouts: ${name}`, fail, measure);
      rows.push(row && {name, pieces: outlines.length, ...row});
    }
  }
  return rows.filter(isThere);
}

const cases = (seeds) =>
  repeats.flatMap((repeat) => Array.from({length: seeds}, (_, k) => ({repeat, seed: k + 1})));

/** Measures with and without the print, one after the other in one process on each platform. */
async function measureCase(programs, outlines, {group, repeat, seed}) {
  const {signedArea} = await import('../../dist/model/geometry/polyline.js');
  const area = outlines.reduce((sum, {outline}) => sum + Math.abs(signedArea(outline)), 0);
  const cell = {w1: [repeat, 0], w2: [0, repeat]};
  const task = {task: 'nest', group, ...cell, width, pieces: aligned(outlines, repeat, seed)};
  const row = {area: area / width};
  for (const platform of both) {
    const [printed, free] = await programs.ask(platform, [task, {...task, free: true}]);
    row[platform] = {printed, free};
  }
  return row;
}

/** Cut lines of a garment's drafted pieces, in their own coordinates. */
async function cutOutlines(garment, print) {
  const {cut, prepare, readGarment} = await import('../../dist/node/index.js');
  const {onPrint} = await import('../../dist/model/geometry/vectors.js');
  const texts = [garment, print].map(({file}) => readFileSync(file, 'utf8'));
  const drafted = await prepare({garment: texts[0], print: texts[1]});
  const {sheet} = await cut(drafted, {
    ...{print: JSON.parse(texts[1]), garment: await readGarment(texts[0])},
    allowanceCm,
  });
  return sheet.pieces.map(({name, place, cut: [outline]}) => ({
    name,
    outline: outline.map((point) => onPrint(place, point)),
  }));
}

/** Aligns each piece on grain, up or down, at a random place in the print's cell. */
function aligned(outlines, repeat, seed) {
  const next = chance(1000 * seed + repeat);
  return outlines.map((piece) => ({
    ...piece,
    angle: next() < 0.5 ? 0 : Math.PI,
    x: repeat * next(),
    y: repeat * next(),
  }));
}
