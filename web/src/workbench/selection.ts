/** The parts of the pattern that somebody means. */
import {Observable} from './observable.js';
import {sameTarget, type Target} from './state.js';

export class Selection extends Observable {
  #selected: Target | undefined;
  #pointed: Target | undefined;

  /** What was picked last: it stays when the pointer moves on. */
  get selected(): Target | undefined {
    return this.#selected;
  }

  /** What the pointer is over, in the picture or in a list. */
  get pointed(): Target | undefined {
    return this.#pointed;
  }

  select(target: Target | undefined): void {
    if (sameTarget(target, this.#selected)) return;
    this.#selected = target;
    this.changed();
  }

  point(target: Target | undefined): void {
    if (sameTarget(target, this.#pointed)) return;
    this.#pointed = target;
    this.changed();
  }

  clear(): void {
    this.select(undefined);
    this.point(undefined);
  }
}
