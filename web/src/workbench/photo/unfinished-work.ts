/** Keeps the photo in the dialog until a print is made from it, for a reload of the page. */
import {begun, type History} from '../../model/design/history.js';
import type {PhotoStep} from '../../photo/photo-step.js';
import type {PhotoKeeper, UnfinishedPhoto} from '../../photo/photo-keeper.js';
import type {PhotoSession} from './photo-session.js';

/** A photo that was in the dialog before. */
export interface PhotoBefore extends UnfinishedPhoto {
  /** True if a print was made from it. */
  readonly isFinished: boolean;
}

interface Where {
  readonly keeper: PhotoKeeper | undefined;
  /** Image of the design's print. */
  readonly image: string;
}

export class UnfinishedWork {
  readonly #where: () => Where;
  /** State as kept; undefined if nothing of the present photo is kept. */
  #kept: {readonly history: History<PhotoStep> | undefined; readonly name: string} | undefined;

  constructor(where: () => Where) {
    this.#where = where;
  }

  /** Keeps a changed state. */
  keep({picture, history}: PhotoSession, name: string): void {
    const {keeper, image} = this.#where();
    if (this.#kept?.history === history && this.#kept?.name === name) return;
    this.#kept = {history, name};
    void keeper?.keepUnfinished(image, {picture, name, history});
  }

  /** Marks a restored state as kept. */
  resume({history}: PhotoSession, name: string): void {
    this.#kept = {history, name};
  }

  /** Prepares for another photo in the dialog. */
  leave(): void {
    this.#kept = undefined;
  }

  /** Discards the kept photo for good. */
  drop(): void {
    if (this.#kept) void this.#where().keeper?.forgetUnfinished();
    this.leave();
  }

  /**
   * Finds the photo to continue with: the unfinished one of this print; else the one that this
   * print was made from; else the unfinished one of another print.
   * @param isLeft the dialog itself holds the unfinished photo
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
