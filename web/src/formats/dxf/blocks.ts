/** Blocks with what is inserted in them, and where they are inserted themselves. */
import {minus, plus, radians, rotated, type Point} from '../../model/geometry.js';
import {FileError} from '../../model/versioned-file.js';
import type {Block, DxfDocument} from './document.js';
import type {Entity, InsertEntity} from './entities.js';

/** How deep blocks are inserted in blocks; what lies deeper is left out. */
const deepest = 4;

/** More lines, points and insertions no pattern has. */
const mostEntities = 200_000;

/** Whatever but an insertion. */
export type Drawn = Exclude<Entity, InsertEntity>;

export interface PlacedBlock {
  readonly name: string;
  readonly entities: readonly Drawn[];
  /** How often it is inserted, as first or as its mirror image. */
  readonly inserted: {readonly asDrawn: number; readonly mirrored: number};
}

type Map2 = (point: Point) => Point;

function moved(entity: Drawn, map: Map2): Drawn {
  return entity.kind === 'line'
    ? {...entity, points: entity.points.map(map)}
    : {...entity, at: map(entity.at)};
}

const placeOf =
  ({at, scale, angle}: InsertEntity, {base}: Block): Map2 =>
  (point) => {
    const [x, y] = minus(point, base);
    return plus(at, rotated([scale[0] * x, scale[1] * y], radians(angle)));
  };

/** Blocks by the insertions that mean them: of several of one name, each insertion means the next. */
export class Blocks {
  readonly missing = new Set<string>();
  isTooDeep = false;
  readonly #document: DxfDocument;
  readonly #byName = new Map<string, Block[]>();
  readonly #name: string;
  #count = 0;

  /** @param name the file's, for messages */
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

  /** Blocks that are no parts of others, in their order. @throws {FileError} */
  placed(): PlacedBlock[] {
    const inserts = new Map<Block, InsertEntity[]>();
    for (const [insert, block] of this.#meant(this.#document.entities)) {
      inserts.set(block, [...(inserts.get(block) ?? []), insert]);
    }
    const parts = new Set(
      this.#document.blocks.flatMap((block) => this.#meant(block.entities).map(([, part]) => part)),
    );
    return this.#document.blocks
      .filter((block) => !/^[*$]/.test(block.name) && (inserts.has(block) || !parts.has(block)))
      .map((block) => this.#placed(block, inserts.get(block) ?? []));
  }

  /** All that is drawn, insertions too. @throws {FileError} */
  flat(): Drawn[] {
    return this.#expanded(this.#document.entities, []);
  }

  #placed(block: Block, inserts: readonly InsertEntity[]): PlacedBlock {
    const own = this.#expanded(block.entities, [block]);
    const [first] = inserts;
    const isMirror = ({scale}: InsertEntity): boolean => scale[0] * scale[1] < 0;
    const alike = inserts.filter((one) => first && isMirror(one) === isMirror(first)).length;
    return {
      name: block.name,
      entities: first ? own.map((entity) => moved(entity, placeOf(first, block))) : own,
      inserted: {asDrawn: Math.max(1, alike), mirrored: inserts.length - alike},
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
    this.#count += entities.length;
    if (this.#count > mostEntities) {
      throw new FileError(
        this.#name,
        'inserts blocks in blocks without end; export the pieces again.',
      );
    }
    const own = entities.filter((entity): entity is Drawn => entity.kind !== 'insert');
    const parts = this.#meant(entities).flatMap(([insert, block]) => {
      if (around.includes(block)) {
        throw new FileError(
          this.#name,
          `has a block '${block.name}' that is inserted in itself; export the pieces again.`,
        );
      }
      if (around.length > deepest) {
        this.isTooDeep = true;
        return [];
      }
      const place = placeOf(insert, block);
      return this.#expanded(block.entities, [...around, block]).map((part) => moved(part, place));
    });
    return [...own, ...parts];
  }
}
