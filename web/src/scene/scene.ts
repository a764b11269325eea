/** The content of a pattern view as plain data. Lengths in cm, y up. */
import type {Alignment, Point} from '../model/geometry/vectors.js';
import type {GarmentDocument} from '../model/garment/garment-document.js';
import {isInside} from '../model/geometry/polyline.js';
import type {Print} from '../model/print/repeating-print.js';
import type {Pattern, ResultPiece, ResultSeam, SeamSide} from '../model/result/result.js';
import type {MismatchScale} from './colours.js';
import {
  countedSeams,
  driftOf,
  joinedMismatchOf,
  meanOf,
  mismatchOf,
  type Drift,
  type JoinedSeam,
  type SeamMismatch,
} from './mismatch.js';
import {layOutNamed, type Layout} from '../layout/layout.js';
import {pick} from './marks.js';
import {placementsIn} from '../layout/on-body.js';
import {nameLines, textWidth} from '../layout/name-lines.js';
import {panelMarks, type PanelDecisions, type PanelMarks} from '../model/garment/panel-marks.js';
import {readable} from '../model/garment/piece-names.js';
import {offSheet, ontoSheet, type SheetPlace} from '../model/geometry/sheet-place.js';
import {grainOf, symmetriesOf, type SceneSymmetry} from './scene-marks.js';
import {screenMargin} from './sheet-view.js';

/** A displayed piece. Points are in piece coordinates, not in those of the sheet. */
export interface ScenePiece
  extends SheetPlace, Pick<ResultPiece, 'name' | 'triangles' | 'outline' | 'holes'> {
  /** Displayed name. */
  readonly label: string;
  readonly points: readonly Point[];
  readonly alignment: Alignment;
  readonly grain?: readonly [Point, Point];
  /** For each outline edge, the index of the panel's edge in the file, for clicks. */
  readonly edges?: readonly number[];
  /** True for a piece of plain fabric. */
  readonly plain: boolean;
}

export interface SceneSeam extends Pick<ResultSeam, 'a' | 'b'>, SeamMatch {
  readonly counts: boolean;
  /** True for a seam that is drawn without its mismatch, because it is hardly seen. */
  readonly isQuiet?: boolean;
}

/** The match along a seam for the alignments of a scene. */
interface SeamMatch {
  readonly kind: ResultSeam['kind'];
  /** For each edge, the mismatch under its best symmetry of the print. [cm] */
  readonly mismatch: readonly number[];
  /** For each edge, the mean length of its two sides. [cm] */
  readonly lengths: readonly number[];
  /** The edge with the greatest mismatch. [cm] */
  readonly worst: {readonly edge: number; readonly mismatch: number};
  /** Mean weighted by length. [cm] */
  readonly mean: number;
  /** Defined if no symmetry of the print fits the whole seam. */
  readonly drift: Drift | undefined;
}

/** A run of vertices of a piece. */
export interface KeptLine {
  readonly piece: number;
  readonly vertices: readonly number[];
  /** True if a seam is drawn along it. */
  readonly isSewn: boolean;
}

export interface PatternScene {
  readonly pattern: Pattern;
  readonly outline: 'rest' | 'shape';
  readonly print: Print;
  readonly pieces: readonly ScenePiece[];
  readonly seams: readonly SceneSeam[];
  readonly symmetries: readonly SceneSymmetry[];
  /** Parts of outlines that stay as drafted. */
  readonly kept?: readonly KeptLine[];
  /** The upper right corner of the sheet; the lower left is (0, 0). */
  readonly size: Point;
  readonly scale: MismatchScale;
}

export interface SceneOptions {
  /** The displayed state of the pieces. Default `shape`. */
  readonly outline?: 'rest' | 'shape';
  /** One alignment per piece. Default: the pattern's own. */
  readonly alignments?: readonly Alignment[];
  /** Provides labels and grain lines. */
  readonly garment?: Pick<GarmentDocument, 'pieces' | 'names'>;
  /** Overrides the garment's data about its panels. */
  readonly decided?: PanelDecisions;
  /** Size for which the layout is made. [CSS px] */
  readonly viewport?: {readonly width: number; readonly height: number};
  /** Names of the pieces of plain fabric. */
  readonly plain?: ReadonlySet<string>;
  /** Default `absolute`. */
  readonly scale?: MismatchScale;
}

/** Font size of piece names. [CSS px] */
export const labelSize = 12;
/** Greatest width of a line of a name; longer names are broken between words. [CSS px] */
const labelRoom = 96;

export const labelLines = (label: string): readonly string[] =>
  nameLines(label, labelRoom, labelSize);

/** Least scale relative to a layout without names; below it, names get no space. */
const leastShare = 0.75;
/**
 * Greatest scale of a layout, which limits the distance between pieces of a very small garment.
 * [CSS px per cm]
 */
const greatestLayoutScale = 14;

/**
 * Lays pieces out on a sheet of the viewport's proportions, with space below each for its name at
 * the scale of the whole sheet.
 */
function sheet(
  pattern: Pattern,
  labels: readonly string[],
  marks: ReadonlyMap<string, PanelMarks>,
  viewport = {width: 1200, height: 750},
): Layout {
  const lines = labels.map(labelLines);
  const widths = lines.map((some) => Math.max(...some.map((line) => textWidth(line, labelSize))));
  const placements = placementsIn(marks);
  const page = {
    width: Math.max(viewport.width - 2 * screenMargin, 1),
    height: Math.max(viewport.height - 2 * screenMargin, 1),
    greatestScale: greatestLayoutScale,
    gap: 16,
  };
  const named = layOutNamed(
    pattern,
    {
      ...page,
      nameHeight: (piece) => 18 + 1.25 * labelSize * (lines[piece]?.length ?? 0),
      nameWidth: (piece) => widths[piece] ?? 0,
    },
    placements,
  );
  const bare = layOutNamed(
    pattern,
    {...page, nameHeight: () => page.gap, nameWidth: () => 0},
    placements,
  );
  return (named.scale < leastShare * bare.scale ? bare : named).layout;
}

/** Lays a pattern out, and measures the mismatch along its seams. */
export function sceneOf(pattern: Pattern, print: Print, options: SceneOptions = {}): PatternScene {
  const outline = options.outline ?? 'shape';
  const {garment, decided} = options;
  const marks = garment ? panelMarks(garment, decided) : new Map<string, PanelMarks>();
  const labels = pattern.pieces.map(({name}) => marks.get(name)?.label ?? readable(name));
  const {places, width, height} = sheet(pattern, labels, marks, options.viewport);
  const symmetries = symmetriesOf(pattern, outline);
  const axes = new Map(
    symmetries.flatMap((s) => (s.kind === 'piece' ? [[s.piece, s.axis] as const] : [])),
  );
  const scene: PatternScene = {
    ...{pattern, outline, print, symmetries, size: [width, height]},
    scale: options.scale ?? 'absolute',
    pieces: pattern.pieces.map((piece, k) => {
      const {name, triangles, outline: loop, holes, alignment} = piece;
      return {
        ...{name, triangles, outline: loop, holes, alignment, points: piece[outline]},
        label: labels[k] ?? name,
        ...(places[k] ?? {offset: [0, 0]}),
        plain: options.plain?.has(name) ?? false,
        ...grainOf(piece, marks.get(name), axes.get(k)),
      };
    }),
    seams: unmatched(pattern),
  };
  return realigned(scene, options.alignments ?? pattern.pieces.map(({alignment}) => alignment));
}

/** The seams before any mismatch is measured. */
function unmatched(pattern: Pattern): readonly SceneSeam[] {
  const counted = countedSeams(pattern);
  return pattern.seams.map(({a, b, kind}, k) => ({
    ...{
      a,
      b,
      kind,
      mismatch: [],
      lengths: [],
      worst: {edge: 0, mismatch: 0},
      mean: 0,
      drift: undefined,
    },
    counts: counted[k] ?? false,
  }));
}

/**
 * The sheet with other alignments on the print. It shares all geometry with `scene`, so that
 * displaying it is fast.
 */
export function realigned(scene: PatternScene, alignments: readonly Alignment[]): PatternScene {
  const counted = scene.seams.map(({counts}) => counts);
  const {pattern, outline} = scene;
  const local = mismatchOf(pattern, outline, alignments, counted).seams;
  const whole = joinedMismatchOf(pattern, outline, alignments, counted).seams;
  return {
    ...scene,
    pieces: scene.pieces.map((piece, k) => ({
      ...piece,
      alignment: alignments[k] ?? piece.alignment,
    })),
    seams: scene.seams.map((seam, k) => ({...seam, ...matchOf(pattern, local[k], whole[k])})),
  };
}

function matchOf(
  {print}: Pattern,
  local: SeamMismatch | undefined,
  whole: JoinedSeam | undefined,
): SeamMatch | undefined {
  if (!local || !whole) return undefined;
  const {mismatch, lengths} = local;
  const most = Math.max(0, ...mismatch);
  const worst = {edge: Math.max(0, mismatch.indexOf(most)), mismatch: most};
  return {
    ...{kind: whole.kind, mismatch, lengths, worst},
    mean: meanOf(local),
    drift: driftOf(local, whole, print),
  };
}

/** The same sheet with other quiet seams. */
export const withQuiet = (scene: PatternScene, quiet: ReadonlySet<number>): PatternScene => ({
  ...scene,
  seams: scene.seams.map((seam, k) => ({...seam, isQuiet: quiet.has(k)})),
});

/** The same sheet with another print. */
export function reprinted(scene: PatternScene, print: Print): PatternScene {
  const {group, w1, w2} = print;
  const pattern = {...scene.pattern, print: {group, w1, w2}};
  return realigned(
    {...scene, pattern, print},
    scene.pieces.map(({alignment}) => alignment),
  );
}

/** The piece at a point of the sheet, and the point in piece coordinates. */
export function pieceAt(
  scene: PatternScene,
  at: Point,
): {readonly piece: number; readonly point: Point} | undefined {
  for (const [piece, shown] of scene.pieces.entries()) {
    const {points, outline, holes} = shown;
    const point = offSheet(shown, at);
    const inside = (loop: readonly number[]): boolean => isInside(pick(points, loop), point);
    if (inside(outline) && !holes.some(inside)) return {piece, point};
  }
  return undefined;
}

/** Sides of seams as lines on the sheet. Lengths in cm. */
export function lineOf({pieces}: PatternScene, {piece, vertices}: SeamSide): Point[] {
  const shown = pieces[piece];
  return shown ? pick(shown.points, vertices).map((point) => ontoSheet(shown, point)) : [];
}
