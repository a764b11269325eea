/** Changes flaws of the fabric without a pointer; each step shows a message. */
import type {PropertyValues} from 'lit';

import type {Point} from '../../model/geometry/vectors.js';
import type {Flaw} from '../../workbench/marker/lay-step.js';
import {flawAfter, flawAround} from '../../workbench/marker/marker-moves.js';
import {flawSizeWords, flawWords} from '../../workbench/marker/marker-words.js';
import {PieceActions} from './piece-actions.js';

export abstract class FlawActions extends PieceActions {
  static override properties = {
    ...PieceActions.properties,
    chosenFlaw: {state: true},
  };
  /** Index of the selected flaw. */
  declare protected chosenFlaw: number | undefined;
  /** Message of the last change to a flaw; displayed even while the solver lays pieces. */
  protected told = '';

  /** Middle of the visible part of the fabric. */
  protected abstract readonly middle: Point | undefined;

  get flaws(): readonly Flaw[] {
    return this.layouts.step?.flaws ?? [];
  }

  /** Flaws can be marked one after the other, even while the solver lays pieces again. */
  get canMark(): boolean {
    const {bolt, isStale, state} = this.layouts;
    return !isStale && bolt !== undefined && state.kind !== 'failed';
  }

  /** Adds a flaw in the middle of the visible part. */
  putFlaw(): void {
    const {bolt} = this.layouts;
    const {middle} = this;
    if (!bolt || !middle || !this.canMark) return;
    this.addFlaw(flawAround(middle, this.workbench.preferences.chosen.units, bolt));
    this.chooseFlaw(this.flaws.length - 1);
    this.#tell(this.flaws.length - 1);
  }

  /** @param flaw null removes the flaw */
  changeFlaw(number: number, flaw: Flaw | null): void {
    if (!this.canMark || !this.flaws[number]) return;
    const changed = this.flaws.flatMap((one, k) => (k !== number ? [one] : flaw ? [flaw] : []));
    this.layouts.setFlaws(changed);
    this.chooseFlaw(flaw ? number : undefined);
    if (flaw) this.#tell(number);
    else this.told = this.words.flawRemoved(number + 1);
  }

  chooseFlaw(number: number | undefined): void {
    this.choose(undefined);
    this.chosenFlaw = number;
  }

  override choose(number: number | undefined): void {
    super.choose(number);
    this.chosenFlaw = undefined;
  }

  #tell(number: number): void {
    const flaw = this.flaws[number];
    if (!flaw) return;
    const {words, format} = this;
    this.told = `${flawWords(flaw, number + 1, words, format)}, ${flawSizeWords(flaw, words, format)}`;
    this.requestUpdate();
  }

  /** @returns true if the key changed the selected flaw */
  protected pressForFlaw(event: Pick<KeyboardEvent, 'key' | 'shiftKey' | 'altKey'>): boolean {
    const {bolt} = this.layouts;
    const {chosenFlaw: number} = this;
    const flaw = number === undefined ? undefined : this.flaws[number];
    if (number === undefined || !flaw || !bolt || event.altKey) return false;
    const changed = flawAfter(event, flaw, this.workbench.preferences.chosen.units, bolt);
    if (changed === undefined) return false;
    this.changeFlaw(number, changed);
    return true;
  }

  protected override say(text: string): void {
    super.say(text);
    this.told = '';
  }

  protected override letGo(): boolean {
    if (this.chosenFlaw === undefined) return super.letGo();
    this.chooseFlaw(undefined);
    return true;
  }

  protected override willUpdate(changed: PropertyValues<this>): void {
    super.willUpdate(changed);
    if (this.chosenFlaw !== undefined && !this.flaws[this.chosenFlaw]) this.chosenFlaw = undefined;
  }
}
