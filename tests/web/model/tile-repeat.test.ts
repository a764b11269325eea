import {describe, expect, it} from 'vitest';

import {printOf, type DesignPrint} from '@/model/design/design.js';
import {pictureIn, resized, tileSize} from '@/model/design/tile-repeat.js';
import {tileRepeats, type TileRepeat} from '@/model/print/opened-image.js';
import {imageCell, printDistance} from '@/model/print/wallpaper.js';
import {asymmetriesOf, isStriped} from '@/image/asymmetry.js';
import {checkTile, wholeCell} from '@/image/tile-check.js';
import {
  ink,
  leaf,
  painted,
  paper,
  rose,
  within,
  type Painting,
} from '../../support/image/pictures.js';

const print = (repeat: TileRepeat, change: Partial<DesignPrint> = {}): DesignPrint => ({
  ...{title: 'leaf', group: 'p1', oneWay: true, cell: 'primitive', image: 'data:image/png,2'},
  ...{turnDeg: 0, size: {width: 12, height: 10, angleDeg: 90}},
  tile: {image: 'data:image/png,1', repeat, turnedDeg: 0},
  ...change,
});

describe('a picture of 6 x 10 cm', () => {
  it('in half-drop goes on half a picture further down, and shows two of itself in a cell', () => {
    const halfDrop = print('halfDrop', {cell: 'centred'});
    expect(tileSize(halfDrop)).toEqual({width: 6, height: 10, angleDeg: 90});
    const shown = printOf(halfDrop);
    const distance = printDistance(shown);
    expect(distance([1, 2], [7, 7])).toBeCloseTo(0, 9);
    expect(distance([1, 2], [1, 12])).toBeCloseTo(0, 9);
    expect(distance([1, 2], [7, 2])).toBeGreaterThan(4);
    expect(imageCell(shown)).toEqual([
      [12, 0],
      [0, 10],
    ]);
  });

  it.each(tileRepeats)('keeps its size through a change of it, repeated %s', (repeat) => {
    const larger = resized(print(repeat), {width: 9, height: 15, angleDeg: 90});
    expect(tileSize(larger)).toEqual({width: 9, height: 15, angleDeg: 90});
    expect(pictureIn(larger)).toMatchObject({image: 'data:image/png,1', repeat});
  });

  it('is measured as it was opened where its cell lies on its side', () => {
    const turned = print('straight', {
      ...{group: 'pm', turnDeg: 90, size: {width: 10, height: 6, angleDeg: 90}},
      tile: {image: 'data:image/png,1', repeat: 'straight', turnedDeg: 90},
    });
    expect(pictureIn(turned)).toMatchObject({turnDeg: 0, size: {width: 6, height: 10}});
    expect(resized(turned, {width: 3, height: 5, angleDeg: 90}).size).toMatchObject({
      ...{width: 5, height: 3},
    });
  });
});

it('the cell of a half-drop holds two of the smallest', () => {
  /** Two leaves, as a cell of both. */
  const two: Painting = (x, y) => leaf(x % 200, (y + (x < 200 ? 0 : 80)) % 160);
  const size = {width: 10, height: 4, angleDeg: 90};
  expect(wholeCell(painted(400, 160, two), 'p1', size, 2)).toMatchObject({cell: 'centred'});
  expect(wholeCell(painted(400, 160, two), 'p1', size, 1)).toMatchObject({cell: 'primitive'});
  expect(wholeCell(painted(400, 160, two), 'p1', size, 3)).toBeUndefined();
});

describe('what a picture lacks', () => {
  const size = {width: 10, height: 5, angleDeg: 90};
  const stripes: Painting = (x) => (x < 60 ? paper : x < 90 ? ink : x < 150 ? rose : paper);

  it('is said as it is seen: uneven stripes read differently from left to right', () => {
    const pixels = painted(200, 100, stripes);
    const check = checkTile(pixels, 'pmm', size, 'primitive');
    expect(asymmetriesOf(check, 'pmm', 0)).toEqual(['leftRight', 'upsideDown']);
    // the same image, rotated by 90 degrees on the screen
    expect(asymmetriesOf(check, 'pmm', 90)).toEqual(['topBottom', 'upsideDown']);
    expect(isStriped(pixels)).toBe(true);
    expect(isStriped(painted(200, 100, leaf))).toBe(false);
  });

  it('may be quarter turns and diagonals alone', () => {
    const bars: Painting = (x, y) =>
      within(x, y, 100, 100, 60) && Math.abs(y - 100) < 15 ? ink : paper;
    const square = {width: 10, height: 10, angleDeg: 90};
    const check = checkTile(painted(200, 200, bars), 'p4m', square, 'primitive');
    expect(asymmetriesOf(check, 'p4m', 0)).toEqual(['diagonal', 'quarterTurn']);
  });

  it('is nothing where the picture has all of it', () => {
    const check = checkTile(painted(200, 100, stripes), 'pm', size, 'primitive');
    expect(asymmetriesOf(check, 'pm', 0)).toEqual([]);
  });
});
