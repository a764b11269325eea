// Layouts on printed cloth: how long they are, how near to what bounds them, and what they take.
import {readFileSync} from 'node:fs';

import {chance} from '../pairing/network.mjs';
import {both, isThere, unlessBroken, usualOf} from './parts.mjs';

/** Of unlike numbers of pieces, from 4 to 12, and of pieces from wide to long. */
const usualNames = ['tee', 'shirt', 'trousers', 'princess-dress', 'hoodie'];
/** Sides of the print's cell, a square. [cm] */
const repeats = [10, 20];
/** Of the cloth, all of it usable, and around the pieces. [cm] */
const width = 140;
const allowanceCm = 1;

/**
 * The pieces of garments laid on cloth with and without a print of group p2, at alignments by
 * chance, which is harder than those of solved garments: these repeat.
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

/** With the print and without, one after the other in one process on each platform. */
async function measureCase(programs, outlines, {group, repeat, seed}) {
  const {signedArea} = await import('../../dist/model/polyline.js');
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

/** The cut lines of a garment's drafted pieces, in their own coordinates. */
async function cutOutlines(garment, print) {
  const {cut, prepare, readGarment} = await import('../../dist/node/index.js');
  const {onPrint} = await import('../../dist/model/geometry.js');
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

/** Each piece on grain, up or down, anywhere in the print's cell. */
function aligned(outlines, repeat, seed) {
  const next = chance(1000 * seed + repeat);
  return outlines.map((piece) => ({
    ...piece,
    angle: next() < 0.5 ? 0 : Math.PI,
    x: repeat * next(),
    y: repeat * next(),
  }));
}
