/** Checks the structure of results that may have been changed by others. */
import {groupNames} from '../base/core-tables.js';
import {
  fail,
  fieldOf,
  flag,
  listOf,
  number,
  oneOf,
  pairOf,
  shape,
  wholeNumber,
  type Read,
} from '../base/read.js';
import {readAlignment} from '../design/read-design.js';
import type {Point} from '../geometry/vectors.js';
import {scaleLimits} from '../print/print-scale.js';
import {mostTurn} from '../print/print-variant.js';
import type {SolveResult} from '../result/result.js';

const finite = number(-1e9, 1e9);
const point: Read<Point> = pairOf(finite);

const below =
  (count: number): Read<number> =>
  (value, at) =>
    wholeNumber(value, at) < count ? Number(value) : fail(at, `a number below ${count}`);

const otherAlignment = shape({
  ...{pieces: listOf(readAlignment), placedCm: finite, expectedCm: finite},
});

function piece(value: unknown, at: string): void {
  const {rest, shape: after} = shape({rest: listOf(point), shape: listOf(point)})(value, at);
  if (rest.length !== after.length) fail(`${at}.shape`, `as long as '${at}.rest'`);
  const vertex = below(rest.length);
  const {outline} = shape(
    {
      name: (name: unknown, where: string) =>
        typeof name === 'string' ? name : fail(where, 'text'),
      ...{outline: listOf(vertex), holes: listOf(listOf(vertex)), alignment: readAlignment},
      triangles: listOf(listOf(vertex)),
    },
    {grainAngle: finite},
  )(value, at);
  if (outline.length < 3) fail(`${at}.outline`, 'a list of at least three');
}

function checkSeams(value: unknown, pieces: number, at: string): void {
  const side = shape({piece: below(pieces), vertices: listOf(wholeNumber)});
  listOf(shape({a: side, b: side, weight: finite, matched: flag, mismatch: listOf(finite)}))(
    value,
    at,
  );
}

function checkSymmetries(value: unknown, pieces: number, at: string): void {
  const index = below(pieces);
  const maps = {map: readAlignment, pairs: listOf(pairOf(wholeNumber))};
  const kinds = {
    piece: shape({...maps, piece: index}),
    pair: shape({...maps, pieces: pairOf(index)}),
  };
  listOf((entry, where) => {
    const kind = oneOf(['piece', 'pair'])(fieldOf(entry, 'kind'), `${where}.kind`);
    return kinds[kind](entry, where);
  })(value, at);
}

/** Accepts a result whose numbers are finite and whose indices exist; returns it unchanged. */
export const checkedResult: Read<SolveResult> = (value, at) => {
  const inside = (field: string): string => (at === '' ? field : `${at}.${field}`);
  const {pieces} = shape(
    {
      pieces: listOf(piece),
      print: shape(
        {group: oneOf(groupNames), w1: point, w2: point},
        {scale: number(...scaleLimits), turnDeg: number(-mostTurn, mostTurn)},
      ),
      metrics: shape({maxMovedCm: finite}),
    },
    {drafted: listOf(readAlignment), otherAlignments: listOf(otherAlignment)},
  )(value, at);
  if (pieces.length === 0) fail(inside('pieces'), 'a list with at least one piece');
  checkSeams(fieldOf(value, 'seams'), pieces.length, inside('seams'));
  checkSymmetries(fieldOf(value, 'symmetries'), pieces.length, inside('symmetries'));
  return value as SolveResult;
};
