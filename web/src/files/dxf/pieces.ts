/** Reads the pieces of a DXF file in all sizes, one block each, from their system text. */
import {boundary, annotations} from './layers.js';
import type {Drawn, PlacedBlock} from './blocks.js';
import type {LineEntity, PointEntity, TextEntity} from './entities.js';
import type {Loop} from './loops.js';
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
export const hasBoundary = ({entities}: PlacedBlock): boolean =>
  linesOn(entities, boundary).length > 0;

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
    name: text.value('piece name') ?? annotationIn(text) ?? name,
    ...(size !== undefined && {size}),
    quantity: isExact ? said : inserted,
    ...{text, entities},
  };
}

const annotationIn = ({others}: SystemText): string | undefined =>
  others.find(({layer, text}) => annotations.includes(layer) && text !== '')?.text;
