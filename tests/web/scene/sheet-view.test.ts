import {describe, expect, it} from 'vitest';

import type {Point} from '@/model/geometry/vectors.js';
import {
  fitted,
  panned,
  screenMargin,
  toScreen,
  toSheet,
  zoomed,
  type SheetView,
} from '@/scene/sheet-view.js';

const size = {width: 800, height: 600};
const sheet: Point = [100, 40];
const view: SheetView = {centre: [30, 20], scale: 8};

const expectClose = ([x, y]: Point, [ex, ey]: Point): void => {
  expect(x).toBeCloseTo(ex, 9);
  expect(y).toBeCloseTo(ey, 9);
};

describe('the part of the sheet on the screen', () => {
  it('has y up on the sheet and down on the screen', () => {
    expect(toScreen(view, size, [30, 20])).toEqual([400, 300]);
    expect(toScreen(view, size, [31, 21])).toEqual([408, 292]);
  });

  it('leads from screen to sheet and back', () => {
    expectClose(toScreen(view, size, toSheet(view, size, [123, 456])), [123, 456]);
  });

  it('shows the whole sheet, with a margin on the tight sides, when fitted', () => {
    const fit = fitted(sheet, size);
    expectClose(toScreen(fit, size, [0, 20]), [screenMargin, 300]);
    expectClose(toScreen(fit, size, [100, 20]), [800 - screenMargin, 300]);
    expect(toScreen(fit, size, [0, 40])[1]).toBeGreaterThan(screenMargin);
  });

  it('keeps the point under the pointer where it is while zooming', () => {
    const at: Point = [200, 250];
    const before = toSheet(view, size, at);
    const after = zoomed(view, size, sheet, 3, at);
    expect(after.scale).toBe(24);
    expectClose(toSheet(after, size, at), before);
  });

  it('follows the pointer while panning', () => {
    const before = toSheet(view, size, [400, 300]);
    expectClose(toSheet(panned(view, sheet, 24, -16), size, [424, 284]), before);
  });

  it('does not lose the sheet, however far it is moved or zoomed', () => {
    const away = panned(view, sheet, 1e6, 1e6);
    expect(away.centre).toEqual([0, 40]);
    expect(zoomed(view, size, sheet, 1e-9, [0, 0]).scale).toBe(fitted(sheet, size).scale / 2);
    expect(zoomed(view, size, sheet, 1e9, [0, 0]).scale).toBe(400);
  });
});
