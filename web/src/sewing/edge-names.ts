/** Names of edges: from the file, or by their place on the displayed piece. */
import type {Run} from '../clicks/run.js';
import type {EdgeOfPiece, GarmentDocument} from '../model/garment/garment-document.js';
import {angleOf, minus} from '../model/geometry/vectors.js';
import type {PatternScene} from '../scene/scene.js';
import type {SewTexts} from '../texts/sew-texts.js';
import type {Texts} from '../texts/texts.js';

/** Names of outward directions, counter-clockwise from the right. */
const places = [
  ...(['right', 'upperRight', 'top', 'upperLeft'] as const),
  ...(['left', 'lowerLeft', 'bottom', 'lowerRight'] as const),
];

export class EdgeNames {
  readonly #names = new Map<string, string>();
  readonly #sew: SewTexts;

  constructor(
    garment: GarmentDocument,
    scene: Pick<PatternScene, 'pieces'>,
    {lists}: Pick<Texts, 'lists'>,
    sew: SewTexts,
  ) {
    this.#sew = sew;
    for (const [piece, {outline, name}] of garment.pieces.entries()) {
      const {label = name, isTurned = false} = scene.pieces[piece] ?? {};
      const own = outline.map((drafted) => {
        const way = minus(drafted.points.at(-1) ?? drafted.points[0], drafted.points[0]);
        // outward is a quarter turn clockwise of the direction along the edge
        const eighth =
          Math.round((angleOf(way) - Math.PI / 2) / (Math.PI / 4)) + (isTurned ? 4 : 0);
        return drafted.label ?? sew.places[places[(eighth + 16) % 8] ?? 'top'];
      });
      own.forEach((place, edge) => {
        const alike = own.flatMap((other, k) => (other === place ? [k] : []));
        const only = alike.length === 1 ? place : lists.numbered(place, alike.indexOf(edge) + 1);
        this.#names.set(`${piece} ${edge}`, sew.edge(only, label));
      });
    }
  }

  of({piece, edge}: EdgeOfPiece): string {
    return this.#names.get(`${piece} ${edge}`) ?? '';
  }

  ofRun(run: Run): string {
    const [first, second] = run;
    if (!first) return '';
    if (second && run.length === 2 && first.piece !== second.piece)
      return this.#sew.both(this.of(first), this.of(second));
    return run.length === 1 ? this.of(first) : this.#sew.run(run.length, this.of(first));
  }
}

/**
 * Returns the notch of an edge that is nearest to a position; both are shares of the edge's length.
 */
export function nearestNotch(
  {pieces}: GarmentDocument,
  at: EdgeOfPiece,
  share: number,
): number | undefined {
  const own = (pieces[at.piece]?.notches ?? []).filter(
    (notch) => notch.edge === at.edge && notch.at > 0.01 && notch.at < 0.99,
  );
  const [nearest] = own
    .map((notch) => notch.at)
    .sort((one, other) => Math.abs(one - share) - Math.abs(other - share));
  return nearest;
}
