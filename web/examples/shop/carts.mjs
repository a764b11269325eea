// The carts, in memory. Whoever knows a cart's id has the cart, so nobody can guess one: no cookie is needed.
import {randomBytes} from 'node:crypto';

const newId = () => randomBytes(16).toString('base64url');

/** More than a visitor orders, and more than a small shop has visitors; the oldest carts go first. */
const [mostLines, mostCarts] = [50, 10_000];

export class Carts {
  #carts = new Map();

  /** Lines by their ids; undefined where there is no such cart. */
  lines(id) {
    return this.#carts.get(id);
  }

  /** Into a cart, or a new one; in the place of a line, where there is one of that id. @returns the cart's id */
  put(id, lineId, line) {
    if (!this.#carts.has(id)) {
      id = newId();
      this.#carts.set(id, new Map());
      if (this.#carts.size > mostCarts) this.#carts.delete(this.#carts.keys().next().value);
    }
    const lines = this.#carts.get(id);
    const isThere = lines.has(lineId);
    if (isThere || lines.size < mostLines) lines.set(isThere ? lineId : newId(), line);
    return id;
  }

  remove(id, lineId) {
    this.#carts.get(id)?.delete(lineId);
  }
}
