// The carts, in memory. Whoever knows a cart's id has the cart, so nobody can guess one: no cookie is needed.
import {randomBytes} from 'node:crypto';

const newId = () => randomBytes(16).toString('base64url');

/** More than a visitor orders, and more than a small shop has visitors; the oldest carts go first. */
const [mostLines, mostCarts] = [50, 10_000];
/** Of all designs together. They are kept as text, which takes a tenth of what it is read into. [characters] */
const mostText = 50_000_000;

export class Carts {
  #carts = new Map();
  #length = 0;

  /** Lines by their ids; undefined where there is no such cart. */
  lines(id) {
    return this.#carts.get(id);
  }

  /** A line, whose `design` is text, into a cart, or a new one; in the place of a line, where there is one of that id. @returns the cart's id */
  put(id, lineId, line) {
    if (!this.#carts.has(id)) {
      id = newId();
      this.#carts.set(id, new Map());
    }
    const lines = this.#carts.get(id);
    const isThere = lines.has(lineId);
    if (isThere || lines.size < mostLines) {
      this.#length += line.design.length - (lines.get(lineId)?.design.length ?? 0);
      lines.set(isThere ? lineId : newId(), line);
    }
    this.#forgetOldest(id);
    return id;
  }

  remove(id, lineId) {
    const lines = this.#carts.get(id);
    this.#length -= lines?.get(lineId)?.design.length ?? 0;
    lines?.delete(lineId);
  }

  #forgetOldest(kept) {
    for (const [id, lines] of this.#carts) {
      if (this.#carts.size <= mostCarts && this.#length <= mostText) return;
      if (id === kept) continue;
      for (const lineId of [...lines.keys()]) this.remove(id, lineId);
      this.#carts.delete(id);
    }
  }
}
