/**
 * Centres the print on the selected edge, or on the middle of the body if a piece extends to it.
 */
import type {Placement} from '../../model/garment/garment-document.js';
import type {Alignment, Point} from '../../model/geometry/vectors.js';
import {footOnAxis} from '../../model/print/mirror-lines.js';
import {atShare} from '../../model/geometry/polyline.js';
import {turned} from '../../layout/on-body.js';
import {pick} from '../../scene/marks.js';
import type {PatternScene, ScenePiece, SceneSeam} from '../../scene/scene.js';
import {mirrorsOf} from '../mirrors.js';
import type {Selection} from '../selection.js';
import type {ShownSheet} from '../shown-sheet.js';
import type {Solving} from '../solving.js';
import {middleOf} from './print-mover.js';

/** A point of a piece, in its own coordinates. [cm] */
interface Middle {
  readonly piece: ScenePiece;
  readonly at: Point;
}

/** The values of a workbench that are read. */
interface Shown {
  readonly selection: Pick<Selection, 'selected'>;
  readonly sheet: Pick<ShownSheet, 'scenes'>;
  readonly solving: Pick<Solving, 'pattern' | 'found'>;
}

/**
 * Greatest distance of a half from the middle of the body: its edges overlap there, or leave room
 * for a band. [cm]
 */
const offMiddle = 4;

/** Returns the point to centre on: of the selected edge or piece, or of the piece named front. */
export function middleToCentre(workbench: Shown): Middle | undefined {
  const scene = workbench.sheet.scenes?.now;
  if (!scene) return undefined;
  const {pieces, seams} = scene;
  const {selected} = workbench.selection;
  if (selected?.kind === 'seam') {
    const side = seams[selected.seam]?.[selected.side];
    const piece = side && pieces[side.piece];
    return piece && {piece, at: atShare(pick(piece.points, side.vertices), 0.5).at};
  }
  const front = pieces.findIndex(({name}) => /front/i.test(name));
  const number = selected ? selected.piece : Math.max(front, 0);
  const piece = pieces[number];
  return piece && {piece, at: middleOfBody(workbench, scene, number) ?? middleOf(piece)};
}

/**
 * Returns the middle of the body on a piece: on its own axis, or on the axis between it and its
 * mirror image.
 */
function middleOfBody(workbench: Shown, scene: PatternScene, number: number): Point | undefined {
  const piece = scene.pieces[number];
  if (!piece) return undefined;
  for (const one of mirrorsOf(workbench.solving)) {
    if (one.kind === 'piece') {
      if (one.piece === piece.name) return footOnAxis(one.map, middleOf(piece));
    } else if (one.pieces.includes(piece.name)) {
      const twin = one.pieces[one.pieces[0] === piece.name ? 1 : 0];
      const placement = workbench.sheet.scenes?.marks.get(piece.name)?.placement;
      return middleOfSeam(scene, number, twin) ?? middlePlaced(piece, placement);
    }
  }
  return undefined;
}

/** Returns the middle of the longest seam that joins a half to its twin. */
function middleOfSeam(
  {pieces, seams}: PatternScene,
  half: number,
  twin: string,
): Point | undefined {
  const lengthOf = ({a}: SceneSeam): number => a.vertices.length;
  const [seam] = seams
    .filter(({a, b}) => {
      const other = a.piece === half ? b.piece : b.piece === half ? a.piece : -1;
      return pieces[other]?.name === twin;
    })
    .sort((one, other) => lengthOf(other) - lengthOf(one));
  if (!seam) return undefined;
  const {vertices} = seam.a.piece === half ? seam.a : seam.b;
  return atShare(pick(pieces[half]?.points ?? [], vertices), 0.5).at;
}

/**
 * Returns the middle of the body beside a piece, from its placement in the file. It is for halves
 * that are not sewn together.
 */
function middlePlaced(piece: ScenePiece, placement: Placement | undefined): Point | undefined {
  if (!placement) return undefined;
  const {translation, rotation = [0, 0, 0]} = placement;
  const [x, y] = middleOf(piece);
  const across = turned([1, 0, 0], rotation)[0];
  if (Math.abs(across) < 0.7) return undefined; // the piece is at the side of the body
  const away = (translation[0] + turned([x, y, 0], rotation)[0]) / across;
  const half = Math.max(...pick(piece.points, piece.outline).map((point) => point[0])) - x;
  return Math.abs(away) <= half + offMiddle ? [x - away, y] : undefined;
}

/**
 * Returns an alignment with the print upright on the sheet. `motif` puts a motif, which is at the
 * print's origin, on the point. `line` puts the line through the motifs on the point, at the
 * present height.
 */
export function centred({piece, at: [x, y]}: Middle, what: 'motif' | 'line'): Alignment {
  const {isTurned, alignment} = piece;
  return {
    angle: isTurned ? Math.PI : 0,
    translation: [x, what === 'motif' ? y : alignment.translation[1]],
  };
}
