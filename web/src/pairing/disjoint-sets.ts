/** Sets without common members, which only ever grow together. */
export class DisjointSets {
  readonly #parents: number[];

  constructor(count: number) {
    this.#parents = Array.from({length: count}, (_, k) => k);
  }

  /** Returns the first member of the set of another. */
  find(member: number): number {
    let top = member;
    while ((this.#parents[top] ?? top) !== top) top = this.#parents[top] ?? top;
    return top;
  }

  join(one: number, other: number): void {
    this.#parents[this.find(one)] = this.find(other);
  }
}
