/** Growing typed arrays and hash tables, which take a quarter of the memory of plain lists. */

abstract class Growing<T extends Float64Array | Int32Array> {
  protected items: T;
  protected count = 0;

  constructor(items: T) {
    this.items = items;
  }

  get length(): number {
    return this.count;
  }

  protected reserve(more: number): void {
    if (this.count + more <= this.items.length) return;
    const larger = this.grown(2 * this.items.length);
    larger.set(this.items);
    this.items = larger;
  }

  protected abstract grown(size: number): T;

  push(value: number): void {
    this.reserve(1);
    this.items[this.count++] = value;
  }
}

export class Floats extends Growing<Float64Array> {
  constructor() {
    super(new Float64Array(1 << 12));
  }

  protected grown(size: number): Float64Array {
    return new Float64Array(size);
  }

  all(): Float64Array {
    return this.items.subarray(0, this.count);
  }
}

export class Integers extends Growing<Int32Array> {
  constructor() {
    super(new Int32Array(1 << 12));
  }

  protected grown(size: number): Int32Array {
    return new Int32Array(size);
  }

  push3(a: number, b: number, c: number): void {
    this.reserve(3);
    this.items[this.count++] = a;
    this.items[this.count++] = b;
    this.items[this.count++] = c;
  }

  all(): Int32Array {
    return this.items.subarray(0, this.count);
  }
}

/** A hash of two numbers. */
export const hashOf = (a: number, b: number): number => {
  const mixed = Math.imul(a, 0x9e3779b1) ^ Math.imul(b, 0x85ebca6b);
  return Math.imul(mixed ^ (mixed >>> 15), 0xc2b2ae35) >>> 0;
};

/** A power of two of at least twice the number of entries. */
export const tableSize = (count: number): number =>
  1 << Math.max(4, Math.ceil(Math.log2(2 * count)));

/** Points closer than this share of the whole extent are merged. */
const welding = 1e-6;

/**
 * For every point, the index of the first one at its place.
 * @param size coordinates per point
 */
export function welded(coordinates: Float64Array, size: number): Int32Array {
  const count = coordinates.length / size;
  const [low, high] = [
    coordinates.reduce((a, b) => Math.min(a, b), Infinity),
    coordinates.reduce((a, b) => Math.max(a, b), -Infinity),
  ];
  const step = welding * (high - low || 1);
  const at = (point: number, k: number): number =>
    Math.round(((coordinates[size * point + k] ?? 0) - low) / step);
  const mask = tableSize(count) - 1;
  const table = new Int32Array(mask + 1).fill(-1);
  const isSame = (a: number, b: number): boolean => {
    for (let k = 0; k < size; k++) if (at(a, k) !== at(b, k)) return false;
    return true;
  };
  return new Int32Array(count).map((_, point) => {
    let slot = hashOf(hashOf(at(point, 0), at(point, 1)), size > 2 ? at(point, 2) : 0) & mask;
    for (let other = table[slot] ?? -1; other >= 0; other = table[slot] ?? -1) {
      if (isSame(other, point)) return other;
      slot = (slot + 1) & mask;
    }
    table[slot] = point;
    return point;
  });
}
