// What comes from a browser is checked here: that it is a design, that it is one of this shop's, and what it costs.
import {isDeepStrictEqual} from 'node:util';

import {repeatOf} from 'seamwise';
import manifest from 'seamwise/package.json' with {type: 'json'};
import {FileError, prepare, printOfStored, readStoredDesign, problemOfStored} from 'seamwise/node';

import {garmentPath, printPath, sizes} from './catalogue.mjs';

/** Of the solver that the pages are served with, and that the workshop solves with. */
const {version} = manifest;

/** What is said about a design that the shop does not take. */
export class Refused extends Error {}

/** Of the pieces' area, for what is lost between them. */
export const waste = 0.3;
export const centsPerM2 = 2600;
/** A print may be made so much smaller or larger than it was drawn. */
const [least, most] = [0.25, 4];

/** @param host of the shop, as the request named it @throws {Refused} with a sentence for the customer */
export function acceptDesign(text, catalogue, host) {
  let design;
  try {
    design = readStoredDesign(text, 'The design');
  } catch (error) {
    if (error instanceof FileError) throw new Refused(error.message);
    throw error;
  }
  const garmentAt = ownPath(design.garment.url, host);
  const printAt = ownPath(design.print.url, host);
  const [garment, size] = chosenGarment(catalogue, garmentAt, design.garment.size);
  const print = catalogue.prints.find(({name}) => printPath(name) === printAt);
  if (!garment) throw new Refused('This garment is not one of ours.');
  if (!print) throw new Refused('This print is not one of ours.');
  const isAsSold = (path, {sha256}) => catalogue.files.get(path).sha256 === sha256;
  if (!isAsSold(garmentAt, design.garment) || !isAsSold(printAt, design.print)) {
    throw new Refused('We have changed this pattern or print since; please choose it again.');
  }
  checkChanges(design, print);
  checkPieces(design, catalogue.pieces.get(garmentAt));
  // by its path alone, so that the shop may move to another host
  const own = {
    ...design,
    garment: {...design.garment, url: garmentAt},
    print: {...design.print, url: printAt},
  };
  return {garment, size, print, colourway: colourwayOf(design, print), design: own};
}

/** The path of a URL on this host; undefined for any other. */
function ownPath(url, host) {
  const base = `http://${host}`;
  if (!URL.canParse(url, base)) return undefined;
  const {host: named, pathname, search} = new URL(url, base);
  return named === host && search === '' ? pathname : undefined;
}

function chosenGarment({garments}, path, wanted) {
  for (const garment of garments) {
    const size = sizes.find((one) => garmentPath(garment.name, one) === path);
    if (size && (wanted ?? size) === size) return [garment, size];
  }
  return [];
}

/** What the element asks of the solver by itself; where the print lies is the customer's. */
const usualOptions = {maxChangeCm: 1, grain: {default: 'on'}};

/** A design that names what the garment does not have was not made on our pages, and may be of any length. */
function checkPieces({alignments, options: {pins = {}}}, pieces) {
  const isWhole = Object.keys(alignments).length === pieces.size;
  const named = [...Object.keys(alignments), ...Object.keys(pins)];
  if (isWhole && named.every((name) => pieces.has(name))) return;
  throw new Refused('We can only cut the pieces that this pattern has.');
}

function checkChanges({method, symmetry, options, seed, solver, print: changes}, print) {
  if (solver !== version) {
    throw new Refused(
      'This was made with an earlier edition of our pages; please choose it again.',
    );
  }
  const isUsual =
    method === 'best' &&
    seed === 1 &&
    symmetry === 'auto' &&
    isDeepStrictEqual({...options, pins: undefined}, {...usualOptions, pins: undefined}) &&
    (changes.group ?? print.group) === print.group;
  if (!isUsual) throw new Refused('We can only cut what can be chosen on our own pages.');
  const usual = repeatOf(print).size;
  const {width, height} = changes.size ?? usual;
  const isPrintable = [width / usual.width, height / usual.height].every(
    (scale) => scale > 0.99 * least && scale < 1.01 * most,
  );
  if (!isPrintable) throw new Refused('We cannot print this so small or so large.');
}

function colourwayOf({print: {colourway}}, {colourways}) {
  const worn = colourways.find(({name}) => name === (colourway ?? colourways[0].name));
  if (!worn) throw new Refused('This print does not come in that colour.');
  return worn;
}

/** Areas by the garment's path: they do not depend on the print. */
const areas = new Map();

/** @returns areas in m², and the price in cents, which the browser has no part in */
export async function estimate({design, print}, catalogue) {
  const garment = catalogue.files.get(design.garment.url).bytes.toString();
  const text = catalogue.files.get(design.print.url).bytes.toString();
  const area =
    areas.get(design.garment.url) ??
    prepare(problemOfStored(design, {garment, print: text})).then(({pieces}) =>
      pieces.reduce((sum, piece) => sum + areaOf(piece), 0),
    );
  areas.set(design.garment.url, area);
  const {w1, w2} = printOfStored(design, text);
  const repeat = Math.max(Math.hypot(...w1), Math.hypot(...w2));
  const piecesM2 = (await area) / 1e4;
  const clothM2 = piecesM2 * (1 + waste) + (repeat * print.fabric.usableWidthCm) / 1e4;
  return {piecesM2, clothM2, cents: Math.round(clothM2 * centsPerM2)};
}

/** Of a meshed piece. [cm²] */
const areaOf = ({rest, triangles}) =>
  triangles.reduce((sum, corners) => {
    const [[ax, ay], [bx, by], [cx, cy]] = corners.map((vertex) => rest[vertex]);
    return sum + ((bx - ax) * (cy - ay) - (cx - ax) * (by - ay)) / 2;
  }, 0);

/** The design that the product page begins with, as far as its price needs it. */
export function plainDesign(garment, size, print) {
  return {
    print,
    design: {
      garment: {url: garmentPath(garment.name, size)},
      print: {url: printPath(print.name)},
      ...{symmetry: 'auto', method: 'best', options: {}, seed: 1},
    },
  };
}
