// The carts, in memory. The id of a cart gives access to it, so ids cannot be guessed; no cookie is
// needed.
import {randomBytes} from 'node:crypto';

const newId = () => randomBytes(16).toString('base64url');

/**
 * Limits above a visitor's usual order, and above the visitors of a small shop; the oldest carts
 * are removed first.
 */
const [mostLines, mostCarts] = [50, 10_000];
/**
 * Limit for all designs and drawings together. They are stored as text, a tenth of the size of the
 * parsed data.
 * [characters]
 */
const mostText = 50_000_000;

const lengthOf = ({design = '', thumbnail = ''} = {}) => design.length + thumbnail.length;

export class Carts {
  #carts = new Map();
  #length = 0;

  /** Lines by their ids; undefined if there is no such cart. */
  lines(id) {
    return this.#carts.get(id);
  }

  /**
   * Puts a line into a cart, or into a new one; replaces the line with that id, if there is one.
   * The line's `design` and `thumbnail` are text. @returns the cart's id
   */
  put(id, lineId, line) {
    if (!this.#carts.has(id)) {
      id = newId();
      this.#carts.set(id, new Map());
    }
    const lines = this.#carts.get(id);
    const isThere = lines.has(lineId);
    if (isThere || lines.size < mostLines) {
      this.#length += lengthOf(line) - lengthOf(lines.get(lineId));
      lines.set(isThere ? lineId : newId(), line);
    }
    this.#forgetOldest(id);
    return id;
  }

  remove(id, lineId) {
    const lines = this.#carts.get(id);
    this.#length -= lengthOf(lines?.get(lineId));
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
