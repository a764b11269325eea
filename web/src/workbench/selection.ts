/** Parts of the pattern that the user has picked or points at. */
import {Observable} from './observable.js';
import {sameTarget, type Target} from './state.js';

export class Selection extends Observable {
  #selected: Target | undefined;
  #pointed: Target | undefined;

  /** The part that was picked last; it stays when the pointer moves on. */
  get selected(): Target | undefined {
    return this.#selected;
  }

  /** The part under the pointer, in the drawing or in a list. */
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
