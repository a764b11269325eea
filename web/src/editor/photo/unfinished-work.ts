/** Has the photograph on the sheet kept until a print is made of it, so that a page that is loaded again has it still. */
import {begun, type History} from '../../model/history.js';
import type {PhotoStep} from '../print/photo-step.js';
import type {PhotoKeeper, UnfinishedPhoto} from './photo-keeper.js';
import type {PhotoSession} from './photo-session.js';

/** A photograph that was on the sheet before. */
export interface PhotoBefore extends UnfinishedPhoto {
  /** A print was made of it. */
  readonly isFinished: boolean;
}

interface Where {
  readonly keeper: PhotoKeeper | undefined;
  /** The picture of the design's print. */
  readonly image: string;
}

export class UnfinishedWork {
  readonly #where: () => Where;
  /** As it is kept; undefined where nothing of what is on the sheet is. */
  #kept: {readonly history: History<PhotoStep> | undefined; readonly name: string} | undefined;

  constructor(where: () => Where) {
    this.#where = where;
  }

  /** Keeps what has changed. */
  keep({picture, history}: PhotoSession, name: string): void {
    const {keeper, image} = this.#where();
    if (this.#kept?.history === history && this.#kept?.name === name) return;
    this.#kept = {history, name};
    void keeper?.keepUnfinished(image, {picture, name, history});
  }

  /** It is kept already. */
  resume({history}: PhotoSession, name: string): void {
    this.#kept = {history, name};
  }

  /** What is on the sheet next is something else. */
  leave(): void {
    this.#kept = undefined;
  }

  /** Nobody will want to go on with it. */
  drop(): void {
    if (this.#kept) void this.#where().keeper?.forgetUnfinished();
    this.leave();
  }

  /**
   * What to go on with: what was left unfinished at this print; else what this print was made of; else what was left
   * unfinished at another one.
   * @param isLeft the sheet holds what was left itself
   */
  async find(isLeft: boolean): Promise<PhotoBefore | undefined> {
    const {keeper, image} = this.#where();
    const left = isLeft ? undefined : await keeper?.unfinished(image);
    const isMade = image.startsWith('data:') && !left?.isOfPrint;
    const made = isMade ? await keeper?.kept(image) : undefined;
    if (made) return {...made, history: begun(made.step), isFinished: true};
    return left && {...left, isFinished: false};
  }
}
