/** Actions on the pieces on the fabric, for keys, buttons and pointer, and the selected piece. */
import type {PropertyValues} from 'lit';

import type {Alignment, Point} from '../../model/geometry/vectors.js';
import type {PieceOnFabric} from '../../workbench/marker/marker-work.js';
import {sameTarget} from '../../workbench/state.js';
import type {Target} from '../../workbench/workbench.js';
import {MarkerElement} from './marker-element.js';
import {canTurn, placeOn, placeTurned, reachOfPinned} from '../../workbench/marker/marker-moves.js';

export abstract class PieceActions extends MarkerElement {
  static override properties = {
    ...MarkerElement.properties,
    selected: {state: true},
  };
  /** Number of the selected piece. */
  declare protected selected: number | undefined;
  /** Message of the last action. */
  protected said = '';
  /** Distance of the last move in words, if nearer places were occupied. */
  protected went = '';
  /** Scrolls the selected piece into view: in the fabric layout, or also in the page. */
  protected toBeSeen: 'on fabric' | 'on page' | undefined;
  /** Last selected target, here or elsewhere. */
  #target: Target | undefined;

  get isReady(): boolean {
    const {bolt, isStale, isAwaited, state} = this.layouts;
    return !isStale && !isAwaited && bolt !== undefined && state.kind !== 'failed';
  }

  walk(step: 1 | -1): void {
    const {pieces} = this.layouts;
    const from = pieces.findIndex(({number}) => number === this.selected);
    const first = step > 0 ? -1 : 0;
    const next = pieces[((from < 0 ? first : from) + step + pieces.length) % pieces.length];
    if (!next) return;
    this.choose(next.number);
    this.toBeSeen = 'on fabric';
  }

  /** A pinned piece stays pinned, and near its place. */
  turn(takes = false): void {
    const {bolt, pieces} = this.layouts;
    const piece = this.selectedPiece;
    if (!bolt || !piece || !this.isReady) return;
    const reach = this.chosen?.isPinned ? reachOfPinned(bolt) : Infinity;
    const move = placeTurned(pieces, piece, bolt, {takes, reach});
    if (move) {
      this.#go(piece, move);
      return;
    }
    const label = this.labelOf(piece);
    const isHeld = canTurn(piece, bolt) && reach < Infinity;
    const {cannotTurn, noTurnNear} = this.words;
    this.say(isHeld ? noTurnNear(label, this.format.length(reach)) : cannotTurn(label));
  }

  #go(piece: PieceOnFabric, {place, fartherCm}: NonNullable<ReturnType<typeof placeOn>>): void {
    this.move(piece, place);
    this.toBeSeen = 'on page';
    if (fartherCm !== undefined) this.went = this.words.farther(this.format.length(fartherCm));
  }

  takeOff(): void {
    const piece = this.selectedPiece;
    if (!piece || !this.isReady) return;
    this.layouts.remove(piece.number);
    this.choose(undefined);
    this.say(this.words.takenOff(this.labelOf(piece)));
  }

  togglePin(): void {
    const piece = this.selectedPiece;
    if (!piece || !this.isReady) return;
    this.layouts.togglePin(piece.number);
    this.say('');
  }

  pack(): void {
    this.layouts.pack();
    this.say('');
  }

  /** Selects a piece, here and in all other views. */
  choose(number: number | undefined): void {
    this.selected = number;
    this.#target = this.#targetOf(number);
    this.workbench.selection.select(this.#target);
    this.say('');
  }

  #targetOf(number: number | undefined): Target | undefined {
    const {piece: name, result = 0} = this.layouts.sources[number ?? -1] ?? {};
    if (result > 0) return undefined; // other views show the design's own garment
    const piece =
      this.workbench.solving.pattern?.pieces.findIndex((one) => one.name === name) ?? -1;
    return piece < 0 ? undefined : {kind: 'piece', piece};
  }

  hold(): void {
    this.layouts.cancel();
  }

  move({number}: PieceOnFabric, place: Alignment): void {
    this.layouts.move(number, place);
    this.say('');
  }

  /** @param flaw outline [cm] */
  addFlaw(flaw: readonly Point[]): void {
    this.layouts.setFlaws([...(this.layouts.step?.flaws ?? []), flaw]);
  }

  get selectedPiece(): PieceOnFabric | undefined {
    return this.layouts.pieces.find(({number}) => number === this.selected);
  }

  get chosen(): {readonly isPinned: boolean} | undefined {
    const piece = this.selectedPiece;
    return piece && {isPinned: this.layouts.step?.pins.has(piece.number) ?? false};
  }

  get hasPins(): boolean {
    return (this.layouts.step?.pins.size ?? 0) > 0;
  }

  /** Highlights the piece under the pointer, here and in all other views. */
  point(number: number | undefined): void {
    this.workbench.selection.point(this.#targetOf(number));
  }

  protected override willUpdate(changed: PropertyValues<this>): void {
    super.willUpdate(changed);
    const {selected} = this.workbench.selection;
    if (!sameTarget(selected, this.#target)) {
      this.#target = selected;
      this.selected = undefined;
    }
    this.selected ??= this.numberOf(this.#target); // it may be newly laid
  }

  /** Returns the number of the first piece that a target refers to. */
  protected numberOf(target: Target | undefined): number | undefined {
    const name =
      target?.kind === 'piece'
        ? this.workbench.solving.pattern?.pieces[target.piece]?.name
        : undefined;
    const number = this.layouts.sources.findIndex(
      ({piece, result}) => result === 0 && piece === name,
    );
    return number < 0 ? undefined : number;
  }

  protected say(text: string): void {
    this.said = text;
    this.went = '';
    this.requestUpdate();
  }

  protected letGo(): boolean {
    if (this.selected === undefined) return false;
    this.choose(undefined);
    return true;
  }

  /** @returns false while pieces cannot be moved */
  protected nudge(way: Point, takes: boolean): boolean {
    const {bolt, pieces} = this.layouts;
    const piece = this.selectedPiece;
    if (!bolt || !this.isReady) return false;
    if (!piece) {
      this.walk(1);
      return true;
    }
    const move = placeOn(pieces, piece, bolt, way, takes);
    if (move) this.#go(piece, move);
    else this.say(this.words.noWay(this.labelOf(piece)));
    return true;
  }
}
