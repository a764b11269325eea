/** Moves the print inside a piece: the piece is then pinned to it, and the others follow. */
import type {Alignment, Point} from '../../model/geometry.js';
import {onPrint} from '../../picture/fit.js';
import {pick} from '../../picture/marks.js';
import type {ScenePiece} from '../../viewer/scene.js';
import type {Workbench} from '../workbench/workbench.js';

/** The print shifted by a way on the sheet. */
export const shifted = ({angle, translation: [x, y]}: Alignment, [dx, dy]: Point): Alignment => ({
  angle,
  translation: [x + dx, y + dy],
});

/** The print turned counter-clockwise about a point of the piece. */
export function turned({angle, translation}: Alignment, by: number, about: Point): Alignment {
  const [x, y] = onPrint({angle: -by, translation: [0, 0]}, [
    translation[0] - about[0],
    translation[1] - about[1],
  ]);
  return {angle: angle + by, translation: [x + about[0], y + about[1]]};
}

export function middleOf({points, outline}: ScenePiece): Point {
  const loop = pick(points, outline);
  const mean = (axis: 0 | 1): number => {
    const values = loop.map((point) => point[axis]);
    return (Math.min(...values) + Math.max(...values)) / 2;
  };
  return [mean(0), mean(1)];
}

/** Moves of one piece that follow each other quickly are one step of the history. */
export function pin(desk: Workbench, {name}: ScenePiece, alignment: Alignment): void {
  const options = desk.design?.options ?? {};
  desk.change({options: {...options, pins: {...options.pins, [name]: alignment}}}, `pin ${name}`);
}

export function unpin(desk: Workbench, {name}: ScenePiece): void {
  const {pins, ...options} = desk.design?.options ?? {};
  if (!pins || !(name in pins)) return;
  const others = Object.fromEntries(Object.entries(pins).filter(([other]) => other !== name));
  desk.change({
    options: {...options, ...(Object.keys(others).length > 0 && {pins: others})},
  });
}

/** The piece that a look at the front falls on: the selected one, or the one that is called so. */
export function frontOf({selected, scenes}: Workbench): ScenePiece | undefined {
  const pieces = scenes?.now.pieces ?? [];
  if (selected?.kind === 'piece') return pieces[selected.piece];
  return pieces.find(({name}) => /front/i.test(name)) ?? pieces[0];
}

/**
 * Puts the print upright on the middle of a piece: with a motif, which is at the print's origin, in its very
 * middle, or with the line through the motifs along it, as high as it lies.
 */
export function centred(piece: ScenePiece, what: 'motif' | 'line'): Alignment {
  const [x, y] = middleOf(piece);
  return {angle: 0, translation: [x, what === 'motif' ? y : piece.alignment.translation[1]]};
}
