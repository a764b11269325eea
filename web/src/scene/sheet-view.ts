/**
 * The part of the sheet on the screen. Sheet points are in cm, y up; screen points in CSS px from
 * the upper left, y down.
 */
import type {Point} from '../model/geometry/vectors.js';

export interface SheetView {
  /** The sheet point at the centre of the screen. */
  readonly centre: Point;
  /** [CSS px per cm] */
  readonly scale: number;
}

export interface ScreenSize {
  readonly width: number;
  readonly height: number;
}

/** Margin around the whole sheet. [CSS px] */
export const screenMargin = 24;
/**
 * Greatest scale, at which a millimetre is 40 px wide; fabric has no finer details. [CSS px per cm]
 */
const greatestScale = 400;
/** Smallest scale, relative to that of the fitted view. */
const smallest = 0.5;

export const toScreen = (
  {centre, scale}: SheetView,
  {width, height}: ScreenSize,
  [x, y]: Point,
): Point => [width / 2 + (x - centre[0]) * scale, height / 2 - (y - centre[1]) * scale];

export const toSheet = (
  {centre, scale}: SheetView,
  {width, height}: ScreenSize,
  [x, y]: Point,
): Point => [centre[0] + (x - width / 2) / scale, centre[1] - (y - height / 2) / scale];

/** The view of the whole sheet. */
export function fitted(sheet: Point, {width, height}: ScreenSize): SheetView {
  const across = Math.max(width - 2 * screenMargin, 1) / sheet[0];
  const up = Math.max(height - 2 * screenMargin, 1) / sheet[1];
  const scale = Math.min(across, up, greatestScale);
  return {centre: [sheet[0] / 2, sheet[1] / 2], scale};
}

/** The nearest allowed view, whose centre is on the sheet. */
function within(view: SheetView, sheet: Point): SheetView {
  const clamp = (value: number, limit: number): number => Math.min(Math.max(value, 0), limit);
  return {...view, centre: [clamp(view.centre[0], sheet[0]), clamp(view.centre[1], sheet[1])]};
}

/** Scales the view by `factor` about the screen point `at`, which keeps its place on the sheet. */
export function zoomed(
  view: SheetView,
  size: ScreenSize,
  sheet: Point,
  factor: number,
  at: Point,
): SheetView {
  const least = Math.min(fitted(sheet, size).scale * smallest, greatestScale);
  const scale = Math.min(Math.max(view.scale * factor, least), greatestScale);
  const [x, y] = toSheet(view, size, at);
  const centre: Point = [
    x - (at[0] - size.width / 2) / scale,
    y + (at[1] - size.height / 2) / scale,
  ];
  return within({centre, scale}, sheet);
}

/** Moves the view so that the sheet follows a pointer by (dx, dy) on the screen. */
export function panned(view: SheetView, sheet: Point, dx: number, dy: number): SheetView {
  const {centre, scale} = view;
  return within({scale, centre: [centre[0] - dx / scale, centre[1] + dy / scale]}, sheet);
}
