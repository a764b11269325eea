/** Reads the pieces of a DXF file in all sizes, one block each, from their system text. */
import {boundary, annotations} from './layers.js';
import type {Blocks, Drawn, PlacedBlock} from './blocks.js';
import type {LineEntity, PointEntity, TextEntity} from './entities.js';
import {quantityOf, systemText, type SystemText} from './system-text.js';

export interface DxfPiece {
  readonly name: string;
  readonly size?: string;
  readonly quantity: {readonly asDrawn: number; readonly mirrored: number};
  readonly text: SystemText;
  readonly entities: readonly Drawn[];
}

export const linesOn = (entities: readonly Drawn[], ...layers: readonly string[]): LineEntity[] =>
  entities.filter((one): one is LineEntity => one.kind === 'line' && layers.includes(one.layer));

export const pointsOn = (entities: readonly Drawn[], ...layers: readonly string[]): PointEntity[] =>
  entities.filter((one): one is PointEntity => one.kind === 'point' && layers.includes(one.layer));

const textsIn = (entities: readonly Drawn[]): TextEntity[] =>
  entities.filter((one): one is TextEntity => one.kind === 'text');

/** Blocks with a boundary. */
export const blockPieces = (blocks: Blocks): DxfPiece[] =>
  blocks
    .placed()
    .filter(({entities}) => linesOn(entities, boundary).length > 0)
    .map(pieceOf);

export function pieceOf({name, entities, inserted}: PlacedBlock): DxfPiece {
  const text = systemText(textsIn(entities));
  const size = text.value('size');
  const said = quantityOf(text.value('quantity'));
  return {
    name: text.value('piece name') ?? annotationIn(text) ?? name,
    ...(size !== undefined && {size}),
    quantity: {
      asDrawn: Math.max(said.asDrawn, said.mirrored > 0 ? 0 : inserted.asDrawn),
      mirrored: Math.max(said.mirrored, inserted.mirrored),
    },
    ...{text, entities},
  };
}

const annotationIn = ({others}: SystemText): string | undefined =>
  others.find(({layer, text}) => annotations.includes(layer) && text !== '')?.text;
