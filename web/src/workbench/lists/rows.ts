/** Pieces and seams as rows of a table, with their measurements and names. */
import type {Design} from '../../model/design/design.js';
import type {GarmentDocument, GarmentSeam} from '../../model/garment/garment-document.js';
import {degrees, distance, minus, rotated} from '../../model/geometry/vectors.js';
import {seamLetter} from '../../model/garment/letters.js';
import type {GrainLock} from '../../model/garment/grain.js';
import type {Pattern, SeamReason, SeamSide} from '../../model/result/result.js';
import {mismatchSteps, severity} from '../../scene/colours.js';
import {boxOf, lengthOf} from '../../model/geometry/polyline.js';
import {isGathered, type Drift} from '../../scene/mismatch.js';
import {pick} from '../../scene/marks.js';
import type {PatternScene, ScenePiece, SceneSeam} from '../../scene/scene.js';
import type {Format} from '../../texts/format.js';
import {withSampleNames} from '../../texts/sample-names.js';
import type {Texts} from '../../texts/texts.js';
import {lastOf} from '../../model/base/last-of.js';
import type {DesignHistory} from '../design-history.js';
import type {Scenes} from '../scenes.js';
import type {ShownSheet} from '../shown-sheet.js';
import type {Solving} from '../solving.js';

export interface PieceRow {
  /** Index of the piece. */
  readonly piece: number;
  /** Name in the files. */
  readonly name: string;
  readonly label: string;
  /** Size of the piece as drafted. [cm] */
  readonly width: number;
  readonly height: number;
  readonly seams: number;
  /** Greatest change of the outline; undefined before the solve. [cm] */
  readonly moved: number | undefined;
  /**
   * Angle between grain line and length of the fabric. [degrees, 0 to 90; 0 to 180 for a one-way
   * print]
   */
  readonly offGrain: number;
  /** `all`: the setting for all pieces applies. */
  readonly grain: GrainLock | 'all';
  readonly printed: boolean;
  readonly pinned: boolean;
  /** Extent of the outline that stays as drafted. */
  readonly kept: 'all' | 'some' | 'none';
}

export interface SeamRow {
  /** Index of the seam. */
  readonly seam: number;
  /** Unique name. */
  readonly name: string;
  /** Letter of the seam, as on the cutting sheet. */
  readonly letter: string;
  /** The pieces that the seam joins; undefined if the name contains them. */
  readonly between: string | undefined;
  /** Labels of the pieces on sides a and b. */
  readonly sides: readonly [string, string];
  /** Mean length of both sides, as drafted. [cm] */
  readonly length: number;
  /** Mean mismatch along the seam, before and after the solve. [cm] */
  readonly before: number;
  readonly after: number;
  /** Greatest mismatch of any edge. [cm] */
  readonly worst: number;
  /** True if the sides differ too much in length for the print to continue along the whole seam. */
  readonly gathered: boolean;
  /**
   * Mismatch of the print followed along the whole seam; undefined for gathers, since it has no
   * meaning there.
   */
  readonly drift: Drift | undefined;
  /** Reason of the mismatch, if the result contains one. */
  readonly why: SeamReason | undefined;
  /** `after` on the colour scale of the drawing: 0 is a perfect match, 1 the worst colour. */
  readonly severity: number;
  readonly kind: SceneSeam['kind'];
  /** Weight in the solve. */
  readonly weight: number;
  /** Weight in the garment file. */
  readonly ownWeight: number;
  readonly matched: boolean;
  /** Labels of the pieces whose side of the seam stays as drafted. */
  readonly keptOn: readonly string[];
  /**
   * True if the user can switch matching on: neither piece is plain, and the file does not exclude
   * the seam.
   */
  readonly canMatch: boolean;
  /** True if the seam counts; false also for a seam that matches wherever the print is. */
  readonly counts: boolean;
}

/** The values of a workbench that are read. */
export interface Shown {
  readonly history: Pick<DesignHistory, 'design'>;
  readonly solving: Pick<Solving, 'garment' | 'pattern' | 'result'>;
  readonly sheet: Pick<ShownSheet, 'scenes'>;
}

/** Returns no rows before the garment is read. An unchanged workbench returns the same rows. */
export function pieceRows({
  history: {design},
  solving: {pattern, result},
  sheet: {scenes},
}: Shown): readonly PieceRow[] {
  return design && scenes && (result ?? pattern) ? piecesOf(design.options, scenes.now) : [];
}

/** Returns no rows before the garment is read. An unchanged workbench returns the same rows. */
export function seamRows(
  {history: {design}, solving: {garment, pattern, result}, sheet: {scenes}}: Shown,
  texts: Texts,
): readonly SeamRow[] {
  if (!design || !garment || !scenes || !(result ?? pattern)) return [];
  const named = withSampleNames(garment, design.garment.name, texts);
  return seamsOf(named, design.options, scenes, texts);
}

/** "Side seam, left (A), Front to Back, 41 cm, mismatch 2 mm, mirrored" */
export function seamText(row: SeamRow, texts: Texts, format: Format): string {
  const {pattern} = texts;
  const own = `${row.name} (${row.letter})`;
  const name = row.between === undefined ? own : `${own}, ${row.between}`;
  const kind = row.counts ? pattern[row.kind] : pattern.notCounted;
  const text = pattern.seam(name, format.length(row.length), format.fine(row.after), kind);
  const remark = remarkOn(row, texts, format);
  return remark === undefined ? text : `${text}, ${remark}`;
}

/**
 * Returns "meets at one end, 40 mm off at the other". Returns the reason of the mismatch instead if
 * the drift along the seam has no meaning, or is not the cause.
 */
export function remarkOn(
  {drift, gathered, why}: Pick<SeamRow, 'drift' | 'gathered' | 'why'>,
  {lists, remedies}: Texts,
  format: Format,
): string | undefined {
  if (gathered) return remedies.why.gather;
  if (why === 'grain' || (why && !drift)) return remedies.why[why];
  if (!drift) return undefined;
  const [near, far] = [Math.min(drift.start, drift.end), Math.max(drift.start, drift.end)];
  if (drift.isLost) return lists.lost;
  const meets = near <= mismatchSteps[1] && far > mismatchSteps[1];
  return meets ? lists.runsOff(format.fine(far)) : lists.offAlong(format.fine(drift.most));
}

/** Measurements that depend on the outlines alone. */
const measures = lastOf(({pieces, seams}: Pattern) => {
  const way = ({piece, vertices}: SeamSide): number =>
    lengthOf(pick(pieces[piece]?.rest ?? [], vertices));
  return {
    pieces: pieces.map(({rest, shape, outline}, piece) => {
      const loop = pick(rest, outline);
      const after = pick(shape, outline);
      const {low, high} = boxOf(loop);
      const [width, height] = minus(high, low);
      return {
        width,
        height,
        seams: seams.filter(({a, b}) => a.piece === piece || b.piece === piece).length,
        moved: Math.max(...loop.map((point, k) => distance(point, after[k] ?? point))),
      };
    }),
    lengths: seams.map(({a, b}) => (way(a) + way(b)) / 2),
  };
});

function offGrain({grain, alignment}: ScenePiece, oneWay: boolean): number {
  const line = grain ? minus(grain[1], grain[0]) : ([0, 1] as const);
  const [across, along] = rotated(line, -alignment.angle);
  return degrees(Math.atan2(Math.abs(across), oneWay ? along : Math.abs(along)));
}

/** Returns whether all of an outline, or some of it, stays as drafted. */
function keptOf({kept = [], pieces}: PatternScene, piece: number): PieceRow['kept'] {
  const count = kept
    .filter((line) => line.piece === piece)
    .reduce((sum, {vertices}) => sum + vertices.length - 1, 0);
  if (count === 0) return 'none';
  return count === pieces[piece]?.outline.length ? 'all' : 'some';
}

/** Returns whether all of a side of a seam stays as drafted. */
const isKeptSide = ({kept = []}: PatternScene, {piece, vertices}: SeamSide): boolean =>
  kept.some(
    (line) => line.piece === piece && vertices.every((vertex) => line.vertices.includes(vertex)),
  );

const piecesOf = lastOf((options: Design['options'], scene: PatternScene): readonly PieceRow[] => {
  const known = measures(scene.pattern).pieces;
  return scene.pieces.map((piece, k): PieceRow => {
    const {name, label, plain} = piece;
    const {width = 0, height = 0, seams = 0, moved} = known[k] ?? {};
    const rule = options.grain?.pieces?.[name] ?? 'all';
    return {
      ...{piece: k, name, label, width, height, seams},
      moved: scene.outline === 'shape' ? moved : undefined,
      offGrain: offGrain(piece, scene.print.oneWay ?? false),
      grain: typeof rule === 'string' ? rule : (rule.lock ?? 'all'),
      printed: !plain,
      pinned: options.pins !== undefined && Object.hasOwn(options.pins, name),
      kept: keptOf(scene, k),
    };
  });
});

/** Names from the file or from the pieces, with numbers for equal names. */
function seamNames(
  {pieces, seams}: PatternScene,
  drafted: readonly GarmentSeam[],
  {lists}: Texts,
): readonly Pick<SeamRow, 'name' | 'between' | 'sides'>[] {
  const label = (piece: number): string => pieces[piece]?.label ?? '';
  const all = seams.map(({a, b}, seam) => {
    const sides = [label(a.piece), label(b.piece)] as const;
    const joined = a.piece === b.piece ? lists.within(sides[0]) : lists.between(...sides);
    const own = drafted[seam]?.name;
    return {sides, name: own ?? joined, between: own === undefined ? undefined : joined};
  });
  const count = new Map<string, number>();
  for (const {name} of all) count.set(name, (count.get(name) ?? 0) + 1);
  const met = new Map<string, number>();
  return all.map((one) => {
    const number = (met.get(one.name) ?? 0) + 1;
    met.set(one.name, number);
    return count.get(one.name) === 1 ? one : {...one, name: lists.numbered(one.name, number)};
  });
}

const seamsOf = lastOf(rowsOfSeams);

function rowsOfSeams(
  {seams: drafted}: GarmentDocument,
  options: Design['options'],
  {before, now}: Scenes,
  texts: Texts,
): readonly SeamRow[] {
  const names = seamNames(now, drafted, texts);
  const {lengths} = measures(now.pattern);
  return now.seams.map(({a, b, mean, worst: {mismatch}, drift, kind, counts}, seam): SeamRow => {
    const {sides = ['', ''] as const, name = '', between} = names[seam] ?? {};
    const {weight = 1, matched = true} = drafted[seam] ?? {};
    const own = now.pattern.seams[seam];
    const gathered = counts && own !== undefined && isGathered(own);
    const canMatch = matched && ![a, b].some(({piece}) => now.pieces[piece]?.plain);
    return {
      letter: seamLetter(seam),
      ...{seam, name, between, sides, kind, counts, canMatch},
      keptOn: [a, b].flatMap((side, k) => (isKeptSide(now, side) ? [sides[k] ?? ''] : [])),
      length: lengths[seam] ?? 0,
      before: before.seams[seam]?.mean ?? 0,
      after: mean,
      worst: mismatch,
      gathered,
      drift: counts && !gathered ? drift : undefined,
      why: counts ? own?.why : undefined,
      severity: severity(mean, now.scale),
      weight: options.weights?.[seam] ?? weight,
      ownWeight: weight,
      matched: canMatch && !options.unmatched?.includes(seam),
    };
  });
}
