/** Messages and questions to the user. */
import {Observable} from './observable.js';
import type {DoubtfulPicture, Notice} from './state.js';

export class Notices extends Observable {
  #notice: Notice | undefined;
  #doubtful: DoubtfulPicture | undefined;

  get notice(): Notice | undefined {
    return this.#notice;
  }

  say(notice: Notice | undefined): void {
    if (notice === this.#notice) return;
    this.#notice = notice;
    this.changed();
  }

  /** Image that needs a decision before it becomes the print. */
  get doubtful(): DoubtfulPicture | undefined {
    return this.#doubtful;
  }

  set doubtful(picture: DoubtfulPicture | undefined) {
    if (picture === this.#doubtful) return;
    this.#doubtful = picture;
    this.changed();
  }
}
