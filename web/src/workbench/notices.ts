/** What is said, and what is asked. */
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

  /** What has to be decided before it becomes the print. */
  get doubtful(): DoubtfulPicture | undefined {
    return this.#doubtful;
  }

  set doubtful(picture: DoubtfulPicture | undefined) {
    if (picture === this.#doubtful) return;
    this.#doubtful = picture;
    this.changed();
  }
}
