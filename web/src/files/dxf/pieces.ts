/** Reads the pieces of a DXF file in all sizes, one block each, from their system text. */
import {isInside} from '../../model/geometry/polyline.js';
import {isNoName} from '../base/words.js';
import {annotations, boundary, holdsClosedMarks, roles} from './layers.js';
import type {Drawn, PlacedBlock} from './blocks.js';
import type {LineEntity, PointEntity, TextEntity} from './entities.js';
import {areaOf, bySize, loopsOf, type Loop} from './loops.js';
import {quantityOf, systemText, type SystemText} from './system-text.js';

export interface DxfPiece {
  readonly name: string;
  readonly size?: string;
  readonly quantity: {readonly asDrawn: number; readonly mirrored: number};
  readonly text: SystemText;
  readonly entities: readonly Drawn[];
  /** Closed lines on the layers of boundary, sewn line and cut-outs, if they are known already. */
  readonly loops?: readonly Loop[];
  /** The reason why the piece is not taken unless it is chosen. */
  readonly doubt?: string;
}

export const linesOf = (entities: readonly Drawn[]): LineEntity[] =>
  entities.filter((one): one is LineEntity => one.kind === 'line');

export const linesOn = (entities: readonly Drawn[], ...layers: readonly string[]): LineEntity[] =>
  linesOf(entities).filter(({layer}) => layers.includes(layer));

export const pointsOn = (entities: readonly Drawn[], ...layers: readonly string[]): PointEntity[] =>
  entities.filter((one): one is PointEntity => one.kind === 'point' && layers.includes(one.layer));

const textsIn = (entities: readonly Drawn[]): TextEntity[] =>
  entities.filter((one): one is TextEntity => one.kind === 'text');

/** Returns whether a block draws on the boundary layer, as those of AAMA and ASTM do. */
const hasBoundary = ({entities}: PlacedBlock): boolean => linesOn(entities, boundary).length > 0;

/** Least area of another piece's outline in a block. [share of the largest] */
const leastShare = 0.05;

/**
 * Returns whether a block is a piece: it draws on the boundary layer and names its piece, or has no
 * closed lines outside of each other, as a drawing in one block has.
 */
export function isPieceBlock(placed: PlacedBlock): boolean {
  if (!hasBoundary(placed)) return false;
  const {entities} = placed;
  if (systemText(textsIn(entities)).value('piece name') !== undefined) return true;
  const loops = closedIn(linesOf(entities).filter(({layer}) => !(layer in roles)));
  const [largest] = loops;
  return !loops.some(
    (loop) =>
      largest &&
      areaOf(loop) > leastShare * areaOf(largest) &&
      !loop.points.some((point) => isInside(largest.points, point)) &&
      !largest.points.some((point) => isInside(loop.points, point)),
  );
}

/** The closed polylines that may be outlines, the largest first. */
const closedIn = (lines: readonly LineEntity[]): Loop[] =>
  bySize(
    loopsOf(
      lines.filter(({isClosed, layer}) => isClosed && !holdsClosedMarks(layer)),
      Number.EPSILON,
    ).closed,
  );

export function pieceOf({
  name,
  entities,
  inserted,
}: Pick<PlacedBlock, 'name' | 'entities' | 'inserted'>): DxfPiece {
  const text = systemText(textsIn(entities));
  const size = text.value('size');
  const said = quantityOf(text.value('quantity'));
  const isExact = said !== undefined && said.mirrored + said.asDrawn > 1;
  return {
    name: text.value('piece name') ?? annotationIn(text) ?? writtenIn(text, name) ?? name,
    ...(size !== undefined && {size}),
    quantity: isExact ? said : inserted,
    ...{text, entities},
  };
}

const annotationIn = ({others}: SystemText): string | undefined =>
  others.find(({layer, text}) => annotations.includes(layer) && text !== '')?.text;

/** Names of blocks that programs make up, such as B12, P1_0 or A$C2F. */
const madeUp = /^(?=.*\d)[a-z*$]{0,7}[-_ ]?[\da-f]+(?:[-_]\d+)*$/i;

/** The text that names a piece whose block has a made-up name. */
const writtenIn = ({others}: SystemText, block: string): string | undefined =>
  madeUp.test(block)
    ? others.find(({text}) => /\p{L}{3}/u.test(text) && !isNoName(text))?.text
    : undefined;
