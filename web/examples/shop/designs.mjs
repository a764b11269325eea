// What comes from a browser is checked here: that it is a design, that it is one of this shop's, and what it costs.
import {isDeepStrictEqual} from 'node:util';

import {repeatOf} from 'seamwise';
import manifest from 'seamwise/package.json' with {type: 'json'};
import {FileError, order, readStoredDesign} from 'seamwise/node';

import {garmentPath, printPath, sizes} from './catalogue.mjs';
import {centsFor, metresFor, money} from './price.mjs';

/** Of the solver that the pages are served with, and that the workshop solves with. */
const {version} = manifest;

/** What is said about a design that the shop does not take. */
export class Refused extends Error {}

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

/**
 * The design solved and laid on its cloth here, from the shop's own files: the browser has no part in its price.
 * @param shownCents what its page has shown, if it has shown a price
 * @returns how much cloth it is cut from, and what that costs
 * @throws {Refused} where the customer was shown another garment or another price
 */
export async function priced({design, print}, shownCents, catalogue, signal) {
  const {reproduced, plan} = await order(design, {
    read: (url) => Promise.resolve(catalogue.files.get(url).bytes),
    cloth: clothOf(print),
    signal,
  });
  if (!reproduced) throw new Refused('This is not what our pages show; please choose it again.');
  const cents = centsFor(plan.lengthCm);
  if (shownCents !== undefined && shownCents !== cents) {
    throw new Refused(
      `This takes ${metresFor(plan.lengthCm).toFixed(2)} m of cloth and costs ${money(cents)}, which is not what you were shown; please choose it again.`,
    );
  }
  return {lengthCm: plan.lengthCm, cents};
}

/** A bolt of a print, as `cloth-width` and `selvedge` of the page have it; of no other width is anything asked. */
const clothOf = ({fabric}) => ({widthCm: fabric.usableWidthCm, selvedgeCm: 0, widthsCm: []});
