// Checks input from browsers: whether it is a design, whether it is one of this shop's, and its
// price.
import {isDeepStrictEqual} from 'node:util';

import {repeatOf} from 'seamwise';
import manifest from 'seamwise/package.json' with {type: 'json'};
import {FileError, order, orderRecord, readStoredDesign} from 'seamwise/node';

import {garmentPath, printPath, sizes} from './catalogue.mjs';
import {centsFor, metresFor, money} from './price.mjs';

/** Version of the solver for both the pages and the workshop. */
const {version} = manifest;

/** Error for a design that the shop does not accept; its message is for the customer. */
export class Refused extends Error {}

/** Least and greatest factor by which a print may be scaled. */
const [least, most] = [0.25, 4];

/** @param host  of the shop, from the request @throws {Refused} with a message for the customer */
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
  // keeps only the path, so that the shop may move to another host
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

/** The element's default options; the alignment is the customer's choice. */
const usualOptions = {maxChangeCm: 1, grain: {default: 'on'}};

/**
 * A design with other pieces than the garment's was not made on our pages, and may have any length.
 */
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

/**
 * Solves the design and lays it out on its fabric, from the shop's own files: the browser does not
 * influence the price.
 * @param shownCents  price shown by the customer's page, if any
 * @returns length of the fabric, its price, the number of visible seams that match, and a drawing
 *   of the pieces
 * @throws {Refused} if the customer's page showed another garment or another price
 */
export async function priced({design, print, colourway}, shownCents, catalogue, signal) {
  const solved = await order(design, {
    read: (url) => Promise.resolve(catalogue.files.get(url).bytes),
    cloth: clothOf(print),
    signal,
  });
  const {reproduced, plan} = solved;
  if (!reproduced) throw new Refused('This is not what our pages show; please choose it again.');
  const cents = centsFor(plan.lengthCm);
  if (shownCents !== undefined && shownCents !== cents) {
    throw new Refused(
      `This takes ${metresFor(plan.lengthCm).toFixed(2)} m of cloth and costs ${money(cents)}, which is not what you were shown; please choose it again.`,
    );
  }
  const tile = catalogue.files.get(`/prints/${colourway.image}`).bytes.toString();
  const {visibleSeams, thumbnail} = await orderRecord(solved, {tile});
  return {lengthCm: plan.lengthCm, cents, visibleSeams, thumbnail};
}

/**
 * Fabric of a print, like `cloth-width` and `selvedge` of the page; no other widths are calculated.
 */
const clothOf = ({fabric}) => ({widthCm: fabric.usableWidthCm, selvedgeCm: 0, widthsCm: []});
