/** Screen positions for clicks in the page's pattern. */
import type {Locator, Page} from 'playwright-core';

import type {Point} from '@/model/geometry/vectors.js';
import type {PatternPane} from '@/editor/pattern/pattern-pane.js';

const pattern = (page: Page): Locator => page.locator('sw-pattern');

interface Place {
  readonly seam?: number;
  readonly side?: 'a' | 'b';
  readonly piece?: string;
  readonly share: number;
}

/**
 * Runs in the page: a point of a piece, as a share along a side of a seam or in the middle of the
 * piece.
 */
function locate(pane: PatternPane, {seam, side, piece, share}: Place): Point | null {
  const stage = pane.shadowRoot?.querySelector('.stage');
  const scene = pane.workbench.sheet.scenes?.now;
  if (!pane.view || !stage || !scene) return null;
  const line = seam === undefined ? undefined : scene.seams[seam]?.[side ?? 'a'];
  const shape = scene.pieces.find(({name}, k) => (line ? k === line.piece : name === piece));
  if (!shape) return null;
  const at = ((): Point => {
    if (line)
      return (
        shape.points[line.vertices[Math.round(share * (line.vertices.length - 1))] ?? 0] ?? [0, 0]
      );
    const loop = shape.outline.map((v) => shape.points[v] ?? [0, 0]);
    const middle = (axis: 0 | 1): number => {
      const values = loop.map((p) => p[axis]);
      return (Math.min(...values) + Math.max(...values)) / 2;
    };
    return [middle(0), middle(1)];
  })();
  const sign = shape.isTurned ? -1 : 1;
  const [x, y] = pane.view.screenOf([
    sign * at[0] + shape.offset[0],
    sign * at[1] + shape.offset[1],
  ]);
  const {left, top} = stage.getBoundingClientRect();
  return [left + x, top + y];
}

async function placeOf(page: Page, what: Place): Promise<[number, number]> {
  const at = await pattern(page).evaluate(locate, what);
  if (!at) throw new Error(`${JSON.stringify(what)} is not on the screen.`);
  return [at[0], at[1]];
}

async function clickAt(page: Page, what: Place): Promise<void> {
  await page.mouse.click(...(await placeOf(page, what)));
}

/** The middle of a piece in the window. [CSS px] */
export const middleOfPiece = (page: Page, piece: string): Promise<[number, number]> =>
  placeOf(page, {piece, share: 0});

export const clickSeam = (page: Page, seam: number, side: 'a' | 'b', share = 0.5): Promise<void> =>
  clickAt(page, {seam, side, share});

export const clickPiece = (page: Page, piece: string): Promise<void> =>
  clickAt(page, {piece, share: 0});

/**
 * Number of the seam with this name in the displayed garment, and the side that a piece has in it.
 */
export async function seamOf(
  page: Page,
  name: string,
  piece: string,
): Promise<{readonly seam: number; readonly side: 'a' | 'b'}> {
  const found = await pattern(page).evaluate(
    ({workbench}: PatternPane, [wanted, owner]) => {
      const scene = workbench.sheet.scenes?.now;
      const file = JSON.parse(workbench.history.design?.garment.text ?? '{}') as {
        seams?: {name?: string}[];
      };
      const seam = file.seams?.findIndex((one) => one.name === wanted) ?? -1;
      const {a} = scene?.seams[seam] ?? {};
      if (!scene || !a) return null;
      return {seam, side: scene.pieces[a.piece]?.name === owner ? ('a' as const) : ('b' as const)};
    },
    [name, piece] as const,
  );
  if (!found) throw new Error(`There is no seam '${name}'.`);
  return found;
}
