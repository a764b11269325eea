/** The parts of a DXF file: header, blocks in order, and entities outside of blocks. */
import type {Point} from '../../model/geometry/vectors.js';
import {FileError} from '../../model/base/versioned-file.js';
import {entityOf, mostVertices, type Entity} from './entities.js';
import {groupsOf, type Group} from './tags.js';

/** A block. Names need not be unique: some programs give all blocks the same name. */
export interface Block {
  readonly name: string;
  readonly base: Point;
  readonly entities: Entity[];
}

export interface DxfDocument {
  /** Integer values of the header, by variable name. */
  readonly header: ReadonlyMap<string, number>;
  readonly blocks: readonly Block[];
  readonly entities: readonly Entity[];
  /** Numbers of lines that the drawing hides, by the reason. */
  readonly hidden: ReadonlyMap<string, number>;
}

/** Greatest number of entities; garments have thousands. */
const mostEntities = 200_000;

/**
 * Parses a file.
 * @throws {FileError} if it is damaged or too large
 */
export function documentOf(text: string, name: string): DxfDocument {
  const header = new Map<string, number>();
  const blocks: Block[] = [];
  const entities: Entity[] = [];
  let section = '';
  let count = 0;
  let open: Block | undefined;
  let polyline: Group | undefined;
  let vertices: Group[] = [];
  const hidden = new Map<string, number>();
  const shut = new Map<string, string>();
  const add = (group: Group): void => {
    if (group.type === 'LAYER') readLayer(group, shut);
    if (section !== 'BLOCKS' && section !== 'ENTITIES') return;
    const entity = entityOf(group, vertices);
    const reason = entity && hiddenBecause(group, shut);
    if (reason !== undefined) {
      if (entity?.kind !== 'text') hidden.set(reason, (hidden.get(reason) ?? 0) + 1);
      return;
    }
    if (entity && ++count > mostEntities) {
      throw new FileError(
        name,
        `draws more than ${mostEntities} lines and points, which no garment has; export the pieces of one alone.`,
        {reason: 'complex'},
      );
    }
    if (entity) (section === 'BLOCKS' ? open?.entities : entities)?.push(entity);
  };
  for (const group of groupsOf(text, name)) {
    if (polyline && group.type === 'VERTEX') {
      vertices.push(group);
      if (vertices.length > mostVertices) throw polyline.error('has more points than any outline');
      continue;
    }
    if (polyline) add(polyline);
    polyline = undefined;
    if (group.type === 'SECTION') {
      section = group.text(2).trim().toUpperCase();
      if (section === 'HEADER') readHeader(group, header);
    } else if (group.type === 'ENDSEC') section = '';
    else if (group.type === 'POLYLINE') {
      polyline = group;
      vertices = [];
    } else if (group.type === 'BLOCK' && section === 'BLOCKS') {
      open = {
        name: group.text(2).trim(),
        base: [group.number(10, 0), group.number(20, 0)],
        entities: [],
      };
      blocks.push(open);
    } else if (group.type === 'ENDBLK') open = undefined;
    else add(group);
  }
  if (polyline) add(polyline);
  return {header, blocks, entities, hidden};
}

/** Stores the reason why a layer is not shown: it is off, by a negative colour, or frozen. */
function readLayer(group: Group, shut: Map<string, string>): void {
  const name = group.text(2).trim();
  const isOff = group.number(62, 7) < 0;
  const isFrozen = (group.number(70, 0) & 1) === 1;
  const how = isFrozen ? 'frozen' : 'off';
  if (isOff || isFrozen) shut.set(name.toUpperCase(), `on layer ${name}, which is ${how}`);
}

/** The reason why a program does not show an entity; undefined if it does. */
function hiddenBecause(group: Group, shut: ReadonlyMap<string, string>): string | undefined {
  if (group.number(60, 0) === 1) return 'marked as invisible';
  if (group.number(67, 0) === 1) return 'in paper space';
  return shut.get(group.text(8).trim().toUpperCase());
}

function readHeader(group: Group, header: Map<string, number>): void {
  let variable = '';
  for (const {code, value} of group.tags) {
    if (code === 9) variable = value.trim().toUpperCase();
    else if (code === 70) header.set(variable, Number(value));
  }
}
