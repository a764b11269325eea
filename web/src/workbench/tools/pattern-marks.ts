/** Marks over the pattern: highlight and selection, found symmetries, choices, cursors. */
import type {SolveOptions} from '../../model/design/options.js';
import type {Pattern} from '../../model/result/result.js';
import {wayOnSheet} from '../../model/geometry/sheet-place.js';
import type {PanelMarks} from '../../model/garment/panel-marks.js';
import type {DetectedSymmetry} from '../../model/garment/symmetries.js';
import {atShare} from '../../model/geometry/polyline.js';
import {innermost, pick} from '../../scene/marks.js';
import type {OnPiece, Overlay} from '../../scene/overlay.js';
import {shownFold} from '../../scene/folds.js';
import {symmetriesOf, type SceneSymmetry} from '../../scene/scene-marks.js';
import type {PatternScene} from '../../scene/scene.js';
import type {Format} from '../../texts/format.js';
import type {Texts} from '../../texts/texts.js';
import {lastOf} from '../../model/base/last-of.js';
import type {Workbench} from '../workbench.js';
import type {PatternTools, Tool} from './pattern-tools.js';

/** Position of the lens cursor along a seam, from 0 to 1 in sewing order. */
export interface LensCursor {
  readonly seam: number;
  readonly share: number;
}

/** Tools that show the symmetries that were found. */
const symmetryTools: ReadonlySet<Tool> = new Set(['piece', 'pair', 'axis']);

export function overlayOf(
  workbench: Workbench,
  scene: PatternScene,
  tools: PatternTools,
  cursor: LensCursor | undefined,
  texts: Texts,
  format: Format,
): Overlay {
  const {selected, pointed} = workbench.selection;
  const seam =
    pointed?.kind === 'seam' ? pointed : selected?.kind === 'seam' ? selected : undefined;
  const marks = tools.marks(scene, texts, format);
  const chosen = marks.ghosts ?? [];
  const isChoosing = tools.active !== undefined && symmetryTools.has(tools.active);
  const found = isChoosing ? ghostsOf(workbench.solving.found, scene.pattern, scene.outline) : [];
  return {
    ...(seam && {highlight: {seam: seam.seam, side: seam.side}}),
    ...(pointed?.kind === 'piece' && {hoverPiece: pointed.piece}),
    ...(selected?.kind === 'piece' && {selectPiece: selected.piece}),
    cursors: cursorsOf(scene, cursor),
    allPairs: isChoosing,
    signs: signsOf(scene, workbench.history.design?.options),
    ...marks,
    lines: [...foldsOf(scene, workbench.sheet.scenes?.marks), ...(marks.lines ?? [])],
    ghosts: [...found.filter((one) => !chosen.some((other) => isSamePair(one, other))), ...chosen],
  };
}

/** Folds of the garment, which are always displayed. */
const foldsOf = lastOf(
  (
    scene: PatternScene,
    marks: ReadonlyMap<string, PanelMarks> | undefined,
  ): NonNullable<Overlay['lines']> =>
    scene.pieces.flatMap(({name}, piece) =>
      (marks?.get(name)?.drafted?.folds ?? []).flatMap((fold) => shownFold(scene, piece, fold)),
    ),
);

const isSamePair = (one: SceneSymmetry, other: SceneSymmetry): boolean =>
  one.kind === 'pair' && other.kind === 'pair' && one.letter === other.letter;

/** Found symmetries, as the scene would draw them if they were imposed. */
const ghostsOf = lastOf(
  (
    found: readonly DetectedSymmetry[],
    pattern: Pattern,
    outline: PatternScene['outline'],
  ): readonly SceneSymmetry[] => {
    const number = (name: string): number =>
      pattern.pieces.findIndex((piece) => piece.name === name);
    const symmetries = found.map(({map, ...one}) =>
      one.kind === 'piece'
        ? ({kind: 'piece', piece: number(one.piece), map, pairs: []} as const)
        : ({
            kind: 'pair',
            pieces: [number(one.pieces[0]), number(one.pieces[1])],
            map,
            pairs: [],
          } as const),
    );
    return symmetriesOf({...pattern, symmetries}, outline);
  },
);

/** A sign is below the position of the letter of a pair. */
const signsOf = lastOf(
  (scene: PatternScene, {pins}: SolveOptions = {}): NonNullable<Overlay['signs']> =>
    scene.pieces.flatMap((shown, piece) => {
      if (!pins?.[shown.name]) return [];
      const {at, room} = innermost(pick(shown.points, shown.outline));
      const [dx, dy] = wayOnSheet(shown, [0, -0.6 * room]);
      return [{piece, point: [at[0] + dx, at[1] + dy], sign: 'pin'}];
    }),
);

function cursorsOf(scene: PatternScene, cursor: LensCursor | undefined): readonly OnPiece[] {
  const seam = cursor && scene.seams[cursor.seam];
  if (!seam) return [];
  return [seam.a, seam.b].map(({piece, vertices}) => ({
    piece,
    point: atShare(pick(scene.pieces[piece]?.points ?? [], vertices), cursor.share).at,
  }));
}
