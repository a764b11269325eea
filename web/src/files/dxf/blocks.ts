/** Expands the insertions in blocks, and places the blocks. */
import {minus, plus, radians, rotated, type Point} from '../../model/geometry/vectors.js';
import {FileError} from '../../model/base/versioned-file.js';
import {mapped} from '../base/bezier.js';
import type {Block, DxfDocument} from './document.js';
import type {Entity, InsertEntity} from './entities.js';

/** Greatest depth of blocks within blocks; deeper ones are skipped. */
const deepest = 4;

/** Greatest number of entities, above that of any pattern. */
const mostEntities = 200_000;

/** Any entity except an insertion. */
export type Drawn = Exclude<Entity, InsertEntity>;

export interface PlacedBlock {
  readonly name: string;
  readonly entities: readonly Drawn[];
  /** Number of insertions with the orientation of the first, and of mirrored ones. */
  readonly inserted: {readonly asDrawn: number; readonly mirrored: number};
  /** False for blocks that the file defines and never draws. */
  readonly isInserted: boolean;
}

type Map2 = (point: Point) => Point;

function moved(entity: Drawn, map: Map2): Drawn {
  if (entity.kind === 'point' && entity.towards) {
    return {...entity, at: map(entity.at), towards: map(entity.towards)};
  }
  if (entity.kind !== 'line') return {...entity, at: map(entity.at)};
  const {run} = entity;
  return {
    ...entity,
    points: entity.points.map(map),
    ...(run && {run: mapped(run, map)}),
  };
}

/** The document with all coordinates times a factor. */
export function scaled(document: DxfDocument, times: number): DxfDocument {
  const map: Map2 = ([x, y]) => [times * x, times * y];
  const entity = (one: Entity): Entity =>
    one.kind === 'insert'
      ? {
          ...one,
          at: map(one.at),
          copies: {...one.copies, steps: map(one.copies.steps)},
        }
      : moved(one, map);
  return {
    ...document,
    blocks: document.blocks.map((block) => ({
      ...block,
      base: map(block.base),
      entities: block.entities.map(entity),
    })),
    entities: document.entities.map(entity),
  };
}

const placeOf =
  ({at, scale, angle}: InsertEntity, {base}: Block, offset: Point = [0, 0]): Map2 =>
  (point) => {
    const [x, y] = minus(point, base);
    const placed = plus([scale[0] * x, scale[1] * y], offset);
    return plus(at, rotated(placed, radians(angle)));
  };

/** Number of copies of an insertion with columns and rows. */
const countOf = ({copies: {counts}}: InsertEntity): number => counts[0] * counts[1];

/** The offsets of all copies of an insertion. */
function* offsetsOf({copies: {counts, steps}}: InsertEntity): Generator<Point> {
  for (let row = 0; row < counts[1]; row++) {
    for (let column = 0; column < counts[0]; column++) yield [column * steps[0], row * steps[1]];
  }
}

/**
 * Assigns insertions to blocks. If several blocks share a name, consecutive insertions refer to
 * consecutive blocks.
 */
export class Blocks {
  readonly missing = new Set<string>();
  isTooDeep = false;
  readonly #document: DxfDocument;
  readonly #byName = new Map<string, Block[]>();
  readonly #name: string;
  #count = 0;

  /** @param name file name for messages */
  constructor(document: DxfDocument, name: string) {
    this.#document = document;
    this.#name = name;
    for (const block of document.blocks) {
      const key = block.name.toUpperCase();
      const same = this.#byName.get(key);
      if (same) same.push(block);
      else this.#byName.set(key, [block]);
    }
  }

  /**
   * Blocks that are no part of others, in file order. Blocks that a program named are included only
   * if they are inserted.
   * @throws {FileError} for recursive or too many insertions
   */
  placed(): PlacedBlock[] {
    const inserts = new Map<Block, InsertEntity[]>();
    for (const [insert, block] of this.#meant(this.#document.entities)) {
      inserts.set(block, [...(inserts.get(block) ?? []), insert]);
    }
    const parts = new Set(
      this.#document.blocks.flatMap((block) => this.#meant(block.entities).map(([, part]) => part)),
    );
    return this.#document.blocks
      .filter((block) => inserts.has(block) || (!/^[*$]/.test(block.name) && !parts.has(block)))
      .map((block) => this.#placed(block, inserts.get(block) ?? []));
  }

  /** Entities outside of blocks. */
  loose(): Drawn[] {
    return this.#document.entities.filter((entity): entity is Drawn => entity.kind !== 'insert');
  }

  /**
   * All drawn entities with expanded insertions.
   * @throws {FileError} for recursive or too many insertions
   */
  flat(): Drawn[] {
    return this.#expanded(this.#document.entities, []);
  }

  #placed(block: Block, inserts: readonly InsertEntity[]): PlacedBlock {
    const own = this.#expanded(block.entities, [block]);
    const [first] = inserts;
    const isMirror = ({scale}: InsertEntity): boolean => scale[0] * scale[1] < 0;
    const sum = (some: readonly InsertEntity[]): number =>
      some.reduce((count, insert) => count + countOf(insert), 0);
    const alike = sum(inserts.filter((one) => first && isMirror(one) === isMirror(first)));
    return {
      name: block.name,
      entities: first ? own.map((entity) => moved(entity, placeOf(first, block))) : own,
      inserted: {asDrawn: Math.max(1, alike), mirrored: sum(inserts) - alike},
      isInserted: first !== undefined,
    };
  }

  #meant(entities: readonly Entity[]): [InsertEntity, Block][] {
    const used = new Map<string, number>();
    return entities.flatMap((entity): [InsertEntity, Block][] => {
      if (entity.kind !== 'insert') return [];
      const key = entity.block.toUpperCase();
      const same = this.#byName.get(key) ?? [];
      const k = used.get(key) ?? 0;
      used.set(key, k + 1);
      const block = same[k % same.length];
      if (!block) this.missing.add(entity.block);
      return block ? [[entity, block]] : [];
    });
  }

  #expanded(entities: readonly Entity[], around: readonly Block[]): Drawn[] {
    this.#count += 1 + entities.length;
    if (this.#count > mostEntities) this.#refuseCount();
    const own = entities.filter((entity): entity is Drawn => entity.kind !== 'insert');
    const parts = this.#meant(entities).flatMap(([insert, block]) => {
      if (around.includes(block)) {
        throw new FileError(
          this.#name,
          `has a block '${block.name}' that is inserted in itself; export the pieces again.`,
          {reason: 'damaged'},
        );
      }
      if (around.length > deepest) {
        this.isTooDeep = true;
        return [];
      }
      if (countOf(insert) > mostEntities) this.#refuseCount();
      return [...offsetsOf(insert)].flatMap((offset) => {
        const place = placeOf(insert, block, offset);
        return this.#expanded(block.entities, [...around, block]).map((part) => moved(part, place));
      });
    });
    return [...own, ...parts];
  }

  #refuseCount(): never {
    throw new FileError(
      this.#name,
      'inserts blocks in blocks without end; export the pieces again.',
      {reason: 'damaged'},
    );
  }
}
