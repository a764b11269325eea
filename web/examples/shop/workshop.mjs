// The workshop's queue. A solve takes seconds of a core, and anybody can send forged designs, so
// orders are solved one after the other, and nobody fills the queue alone.

/** Most orders that wait or are being solved: of everybody, and of one customer. */
const [mostOrders, mostOfCustomer] = [50, 5];

/** Error for a full queue; its message is for the customer. */
export class Busy extends Error {}

export class Workshop {
  #last = Promise.resolve();
  #orders = 0;
  #ofCustomer = new Map();

  /**
   * Does the work after all work before it.
   * @param customer  address of the customer; behind a proxy, the one that the proxy reports
   * @throws {Busy} if too many orders wait; the error of the work
   */
  async run(customer, work) {
    const own = this.#ofCustomer.get(customer) ?? 0;
    if (this.#orders >= mostOrders || own >= mostOfCustomer) {
      throw new Busy('The workshop has too many orders at once; please try again in a minute.');
    }
    this.#orders += 1;
    this.#ofCustomer.set(customer, own + 1);
    const done = this.#last.then(work);
    this.#last = done.catch(() => undefined);
    try {
      return await done;
    } finally {
      this.#orders -= 1;
      const left = this.#ofCustomer.get(customer) - 1;
      if (left > 0) this.#ofCustomer.set(customer, left);
      else this.#ofCustomer.delete(customer);
    }
  }
}
