/**
 * The lines of a scene: outlines, seams by mismatch, mirror axes, grain lines. Lines of an edge are
 * outside of it.
 */
import {between, distance, minus, unit, type Point} from '../model/geometry/vectors.js';
import {ontoSheet, wayOnSheet, type SheetPlace} from '../model/geometry/sheet-place.js';
import {mismatchLine} from '../scene/colours.js';
import {pick} from '../scene/marks.js';
import type {LineStyle, Stroke} from './line-layer.js';
import {lineOf, type PatternScene, type ScenePiece, type SceneSeam} from '../scene/scene.js';
import {endsOnOutline, outsideOf, shiftsOutside} from './outside.js';

/** Light or dark surroundings. */
export type Appearance = 'light' | 'dark';

type Colour = LineStyle['colour'];

interface Inks {
  /** Background of a picture of the sheet. */
  readonly paper: Colour;
  readonly outline: Colour;
  /** Separates a line from the print under it. */
  readonly casing: Colour;
  readonly mark: Colour;
  readonly quiet: Colour;
  /** Marks the target of the pointer and the selection. */
  readonly accent: Colour;
}

export const inks: Readonly<Record<Appearance, Inks>> = {
  light: {
    paper: [251, 250, 248],
    outline: [74, 77, 82],
    casing: [255, 255, 255],
    mark: [43, 45, 49],
    quiet: [141, 144, 150],
    accent: [36, 98, 214],
  },
  dark: {
    paper: [24, 25, 28],
    outline: [214, 216, 220],
    casing: [24, 25, 28],
    mark: [240, 241, 243],
    quiet: [150, 153, 160],
    accent: [120, 170, 255],
  },
};

/** Gap between the lines beside a kept edge, for the widest seam and its casing. [CSS px] */
const keptRoom = 7;

export const placed = (
  piece: SheetPlace & Pick<ScenePiece, 'points'>,
  vertices: readonly number[],
): Point[] => pick(piece.points, vertices).map((point) => ontoSheet(piece, point));

/**
 * Returns the casing under a stroke, a little wider and without gaps; beside an edge, on the outer
 * side only.
 */
export function cased(stroke: Stroke, colour: Colour): Stroke {
  const wider = stroke.shifts ? 1.2 : 2.2;
  const under = ({width}: LineStyle): LineStyle => ({colour, width: width + wider});
  const {styles} = stroke;
  return {...stroke, styles: 'width' in styles ? under(styles) : styles.map(under)};
}

export function outlineStrokes(scene: PatternScene, appearance: Appearance): readonly Stroke[] {
  const styles = {colour: inks[appearance].outline, width: 1.5};
  return scene.pieces.flatMap((piece) =>
    [piece.outline, ...piece.holes].map((loop) => {
      const points = placed(piece, loop);
      return {points, closed: true, shifts: shiftsOutside(points, 1, true), styles};
    }),
  );
}

/**
 * Colours from green to red on the scene's scale; the worse the mismatch, the wider and the more
 * broken the line. Seams that do not count and quiet ones are dotted.
 */
function seamStyles(
  {counts, isQuiet, mismatch}: SceneSeam,
  {scale}: PatternScene,
  quiet: Colour,
): LineStyle | LineStyle[] {
  if (!counts || isQuiet) return {colour: quiet, width: 2, dash: [0.5, 5]};
  return mismatch.map((one) => {
    const {colour, width, dash} = mismatchLine(one, scale);
    const rgb = Number.parseInt(colour.slice(1), 16);
    return {
      colour: [rgb >> 16, (rgb >> 8) & 255, rgb & 255],
      width,
      ...(dash && {dash}),
    };
  });
}

/** Returns a side of a seam, on the outside of its piece. */
export function besideEdge(
  scene: PatternScene,
  side: SceneSeam['a'],
): Required<Pick<Stroke, 'points' | 'shifts'>> {
  const points = lineOf(scene, side);
  const outside = outsideOf(scene.pieces[side.piece], side.vertices);
  return {points, shifts: shiftsOutside(points, outside)};
}

/** Returns both sides of some seams, over a casing. */
export function seamStrokes(
  scene: PatternScene,
  appearance: Appearance,
  seams = scene.seams,
): readonly Stroke[] {
  const {casing, quiet} = inks[appearance];
  const sides = seams.flatMap((seam) => {
    const styles = seamStyles(seam, scene, quiet);
    return [seam.a, seam.b].map((side): Stroke => ({...besideEdge(scene, side), styles}));
  });
  return [...sides.map((side) => cased(side, casing)), ...sides];
}

/**
 * Returns two lines beside each part of an outline that stays as drafted; a seam fits between them.
 */
export function keptStrokes(scene: PatternScene, appearance: Appearance): readonly Stroke[] {
  const {casing, mark} = inks[appearance];
  return (scene.kept ?? []).flatMap(({piece, vertices, isSewn}): Stroke[] => {
    const points = lineOf(scene, {piece, vertices});
    const inner = isSewn ? keptRoom : 2.4;
    return [
      {points, styles: {colour: mark, width: inner + 2.4}},
      {points, styles: {colour: casing, width: inner}},
    ];
  });
}

/** Returns an arrow head at `tip`, seen from `tail`. */
export function arrowHead(tail: Point, tip: Point): Point[] {
  const size = Math.min(1.6, distance(tail, tip) / 4);
  const [x, y] = unit(minus(tip, tail));
  const barb = (side: number): Point => [
    tip[0] - size * (x - 0.4 * side * y),
    tip[1] - size * (y + 0.4 * side * x),
  ];
  return [barb(1), tip, barb(-1)];
}

/** Length of a grain line's drawn ends; the print between them stays clear. [cm] */
const grainEnd = 2.5;

/** Returns ticks beyond the outline at both ends of a mirror axis, equally long at any zoom. */
export function axisTicks(
  piece: ScenePiece | undefined,
  axis: readonly [Point, Point],
  colour: Colour,
): readonly Stroke[] {
  if (!piece) return [];
  return endsOnOutline(piece, axis).map(({at, out}): Stroke => {
    const end = ontoSheet(piece, at);
    const reach = (widths: number): Point => wayOnSheet(piece, [widths * out[0], widths * out[1]]);
    return {
      points: [end, end],
      shifts: [reach(1), reach(2.9)], // ends above the name
      styles: {colour, width: 2.4},
    };
  });
}

/** Returns the ticks of mirror axes, and the ends of grain lines with an arrow head each. */
export function markStrokes(scene: PatternScene, appearance: Appearance): readonly Stroke[] {
  const {casing, mark} = inks[appearance];
  const grain = scene.pieces.flatMap((piece) => {
    const [from, to] = (piece.grain ?? []).map((point) => ontoSheet(piece, point));
    if (!from || !to) return [];
    const share = Math.min(0.5, grainEnd / (distance(from, to) || 1));
    const lines = [
      [from, between(from, to, share)],
      [to, between(to, from, share)],
      arrowHead(from, to),
      arrowHead(to, from),
    ];
    return lines.map((points): Stroke => ({points, styles: {colour: mark, width: 1}}));
  });
  const axes = scene.symmetries.flatMap((symmetry) =>
    symmetry.kind === 'pair' ? [] : axisTicks(scene.pieces[symmetry.piece], symmetry.axis, mark),
  );
  return [...grain.map((line) => cased(line, casing)), ...grain, ...axes];
}
