/** Folds by two clicks: the state of the tool, and its steps of the history. Lengths in cm. */
import type {OnPiece} from '../../clicks/pick.js';
import {draftedPoint} from '../../clicks/sheet.js';
import type {DesignGarment} from '../../model/design/design.js';
import {designAfter} from '../../model/design/edited-design.js';
import {after, type Edited} from '../../model/garment/edits.js';
import {foldLines, hidesFabric} from '../../model/garment/folds.js';
import type {
  DraftedFold,
  FoldKind,
  GarmentDocument,
  GarmentPiece,
} from '../../model/garment/garment-document.js';
import {nearestOn} from '../../model/geometry/nearest.js';
import {distance} from '../../model/geometry/vectors.js';
import {editedPattern} from '../../sewing/edited-pattern.js';
import {
  foldImage,
  foldLike,
  isSameFold,
  overlapsPleat,
  replaceFold,
  withFold,
  withoutFold,
} from '../../sewing/fold-edits.js';
import {
  firstLine,
  foldAt,
  innerLineAt,
  uptakeOf,
  withLength,
  withUptake,
  type FoldPlace,
  type FoldRefusal,
} from '../../sewing/fold-places.js';
import {grownGathers} from '../../sewing/seam-edits.js';
import type {Pointed} from '../later-tool.js';
import {mirrorsOf} from '../mirrors.js';
import type {Workbench} from '../workbench.js';

/** A place of a fold line on a piece. */
export interface Spot extends OnPiece {
  /** In coordinates of the drafted piece, face up. */
  readonly place: FoldPlace;
}

/** A fold by the numbers of its piece and of itself. */
interface FoldNumber {
  readonly piece: number;
  readonly fold: number;
}

type Refusal = FoldRefusal | 'otherPiece' | 'overlaps';

interface FoldState {
  readonly first?: Spot;
  readonly selected?: FoldNumber;
  readonly refused?: Refusal;
}

export class FoldChooser {
  readonly #workbench: Workbench;
  readonly #changed: () => void;
  /** Kind of the next fold. */
  #kind: FoldKind = 'knife';
  /** Folds are made, changed and removed on the mirrored side, too. */
  #isMirrored = true;
  #latest: FoldState = {};
  /** The garment that `#latest` belongs to. */
  #garment: DesignGarment | undefined;
  #hovered: Spot | undefined;
  /** The place that the keys move. */
  #cursor: Spot | undefined;

  constructor(workbench: Workbench, changed: () => void) {
    this.#workbench = workbench;
    this.#changed = changed;
  }

  get state(): FoldState {
    this.#forget();
    return this.#latest;
  }

  /** Drops the places on another garment, such as after an undo. */
  #forget(): void {
    const garment = this.#workbench.history.design?.garment;
    if (garment !== this.#garment) {
      this.#latest = {};
      this.#garment = garment;
      this.#hovered = this.#cursor = undefined;
    }
  }

  get garment(): GarmentDocument | undefined {
    return this.#workbench.solving.garment;
  }

  /** Kind of the selected fold, or of the next one. */
  get kind(): FoldKind {
    return this.fold?.kind ?? this.#kind;
  }

  /** The selected fold. */
  get fold(): DraftedFold | undefined {
    const {selected} = this.state;
    return selected && this.#piece(selected.piece)?.folds?.[selected.fold];
  }

  /** Length of the selected fold. */
  get lengthCm(): number {
    return this.fold ? distance(...this.fold.line) : 0;
  }

  /** Fabric in the selected pleat. */
  get uptakeCm(): number {
    return this.fold ? uptakeOf(this.fold) : 0;
  }

  get isMirrored(): boolean {
    return this.#isMirrored;
  }

  /** True if the piece in question has a mirror image, or is one of itself. */
  get hasMirror(): boolean {
    const {selected, first} = this.state;
    const piece = selected?.piece ?? first?.piece;
    if (piece === undefined) return mirrorsOf(this.#workbench.solving).length > 0;
    const {fold} = this;
    return fold ? this.#images(piece, fold).length > 0 : this.#mirrorsOf(piece).length > 0;
  }

  /** All folds of the garment, in order. */
  get all(): readonly FoldNumber[] {
    const {pieces = []} = this.garment ?? {};
    return pieces.flatMap(({folds = []}, piece) => folds.map((_, fold) => ({piece, fold})));
  }

  get cursor(): Spot | undefined {
    this.#forget();
    return this.#cursor;
  }

  /** The place under the pointer, or the one that the keys move. */
  get pointed(): Spot | undefined {
    this.#forget();
    return this.#cursor ?? this.#hovered;
  }

  /** The fold that the next press would make, or the first line of it. */
  get preview(): DraftedFold | undefined {
    const {state, pointed, kind} = this;
    const piece = this.#piece(state.first?.piece ?? pointed?.piece);
    if (!piece || state.selected) return undefined;
    const {first} = state;
    if (first && pointed?.piece === first.piece) {
      const fold = foldAt(piece, kind, [first.place, pointed.place]);
      if (typeof fold !== 'string') return fold;
    }
    const place = (first ?? pointed)?.place;
    const line = place && (hidesFabric({kind}) || place.line) && firstLine(piece, place);
    return line ? {kind, line} : undefined;
  }

  #piece(number: number | undefined): GarmentPiece | undefined {
    return this.garment?.pieces[number ?? -1];
  }

  #set(state: FoldState): void {
    this.#latest = {...state};
    this.#garment = this.#workbench.history.design?.garment;
    this.#changed();
  }

  hover(at: Pointed | undefined): void {
    const before = this.#hovered;
    this.#hovered = at && this.#spot(at);
    if (before || this.#hovered) this.#changed();
  }

  #spot({target, point, reachCm}: Pointed): Spot | undefined {
    const scene = this.#workbench.sheet.scenes?.now;
    const piece = this.#piece(target.piece);
    if (!scene || !piece) return undefined;
    const at = (p: OnPiece['point']) => draftedPoint(scene, target.piece, p);
    const line =
      target.kind === 'piece' ? innerLineAt(piece, at(target.point), 2 * reachCm) : undefined;
    const place = {point: at(point), ...(line && {line})};
    return {piece: target.piece, point, place};
  }

  /** Sets a place, or selects the fold there. */
  take(at: Pointed): void {
    const spot = this.#spot(at);
    if (!spot) return;
    const {first} = this.state;
    const fold = first ? -1 : this.#foldAt(at, spot);
    this.#workbench.selection.select({kind: 'piece', piece: spot.piece});
    if (fold >= 0) this.select({piece: spot.piece, fold});
    else this.set(spot);
  }

  /** Number of the fold near a press inside a piece; -1 without one. */
  #foldAt({target, reachCm}: Pointed, {piece}: Spot): number {
    const scene = this.#workbench.sheet.scenes?.now;
    const {folds = []} = this.#piece(piece) ?? {};
    if (!scene || target.kind !== 'piece') return -1;
    const point = draftedPoint(scene, piece, target.point);
    const offs = folds.map((fold) =>
      Math.min(...foldLines(fold).map((line) => nearestOn(line, point, false).off)),
    );
    const least = Math.min(...offs);
    return least < 2 * reachCm ? offs.indexOf(least) : -1;
  }

  /** Sets the first place, or makes the fold at the second one. */
  set(spot: Spot): void {
    const {first} = this.state;
    const isLine = spot.place.line !== undefined && !hidesFabric({kind: this.#kind});
    if (first && first.piece !== spot.piece) this.#refuse('otherPiece');
    else if (first) this.#make(first, spot);
    else if (isLine) this.#make(spot, spot);
    else this.#set({first: spot});
  }

  #refuse(refused: Refusal): void {
    const {first} = this.state;
    this.#set({...(first && {first}), refused});
  }

  #make({piece, place: first}: Spot, {place: second}: Spot): void {
    const {garment} = this;
    const drafted = this.#piece(piece);
    if (!garment || !drafted) return;
    const fold = foldAt(drafted, this.#kind, [first, second]);
    if (typeof fold === 'string') this.#refuse(fold);
    else if (overlapsPleat(garment, piece, fold)) this.#refuse('overlaps');
    else {
      const images = this.#isMirrored ? this.#images(piece, fold) : [];
      const edited = images.reduce(
        (done, image) =>
          overlapsPleat(done.document, image.piece, image.fold)
            ? done
            : after(done, (next) => withFold(next, image.piece, image.fold)),
        withFold(garment, piece, fold),
      );
      this.#take(garment, edited, {piece, fold});
    }
  }

  select(selected: FoldNumber | undefined): void {
    this.#cursor = undefined;
    this.#set(selected ? {selected} : {});
  }

  /** Selects the next fold of the garment. @returns false beyond the last one */
  walk(by: 1 | -1): boolean {
    const {all, state} = this;
    const at = all.findIndex(
      ({piece, fold}) => piece === state.selected?.piece && fold === state.selected.fold,
    );
    const next = at < 0 ? (by > 0 ? all[0] : all.at(-1)) : all[at + by];
    this.select(next);
    if (next) this.#workbench.selection.select({kind: 'piece', piece: next.piece});
    return next !== undefined;
  }

  /** Changes the kind of the selected fold, and of the next ones. */
  setKind(kind: FoldKind): void {
    const {fold} = this;
    this.#kind = kind;
    if (!fold) {
      this.#set(this.state);
    } else if (hidesFabric(fold) === hidesFabric({kind})) {
      this.#change((one, piece) =>
        kind === 'tuck' || one.kind !== 'tuck'
          ? {...one, kind}
          : {...withLength(piece, one, undefined), kind},
      );
    }
  }

  setUptake(cm: number): void {
    this.#change((fold, piece) => withUptake(piece, fold, cm));
  }

  /** @param cm from the edge; a greater length ends at the other side of the piece */
  setLength(cm: number): void {
    this.#change((fold, piece) => withLength(piece, fold, cm));
  }

  /** Lays the second line on the first. */
  reverse(): void {
    this.#change((fold) => (fold.to ? {...fold, line: fold.to, to: fold.line} : fold));
  }

  setMirrored(isMirrored: boolean): void {
    this.#isMirrored = isMirrored;
    this.#set(this.state);
  }

  remove(): void {
    const {garment, state, fold} = this;
    const {selected} = state;
    if (!garment || !selected || !fold) return;
    const edited = this.#alike(selected.piece, fold).reduce(
      (done, image) =>
        after(done, (next) =>
          withoutFold(next, image.piece, foldLike(next, image.piece, image.fold)),
        ),
      withoutFold(garment, selected.piece, selected.fold),
    );
    this.#take(garment, edited, undefined);
  }

  /** Undoes one step of the tool. @returns true if there was one */
  back(): boolean {
    const {first, selected, refused} = this.state;
    if (!first && !selected && !refused && !this.#cursor) return false;
    if (!first) this.#cursor = undefined;
    this.#set({});
    return true;
  }

  /** Moves the place that the keys set. */
  moveCursor(spot: Spot | undefined): void {
    this.#cursor = spot;
    this.#set(this.state.first ? {first: this.state.first} : {});
  }

  #change(change: (fold: DraftedFold, piece: GarmentPiece) => DraftedFold): void {
    const {garment, state, fold} = this;
    const {selected} = state;
    const piece = this.#piece(selected?.piece);
    if (!garment || !selected || !fold || !piece) return;
    const changed = change(fold, piece);
    const rest = withoutFold(garment, selected.piece, selected.fold).document;
    if (overlapsPleat(rest, selected.piece, changed)) {
      this.#set({selected, refused: 'overlaps'});
      return;
    }
    const edited = this.#alike(selected.piece, fold).reduce(
      (done, image) => {
        const number = foldLike(done.document, image.piece, image.fold);
        const before = done.document.pieces[image.piece];
        const other = before?.folds?.[number];
        return before && other
          ? after(done, (next) => replaceFold(next, image.piece, number, change(other, before)))
          : done;
      },
      replaceFold(garment, selected.piece, selected.fold, changed),
    );
    this.#take(garment, edited, {piece: selected.piece, fold: changed});
  }

  #mirrorsOf(piece: number) {
    const {name} = this.#piece(piece) ?? {};
    return mirrorsOf(this.#workbench.solving).filter((one) =>
      one.kind === 'piece' ? one.piece === name : one.pieces.includes(name ?? ''),
    );
  }

  /** Mirror images of a fold, without those that are the fold itself. */
  #images(
    piece: number,
    fold: DraftedFold,
  ): readonly {readonly piece: number; readonly fold: DraftedFold}[] {
    const {pieces = []} = this.garment ?? {};
    const name = pieces[piece]?.name;
    return this.#mirrorsOf(piece).flatMap((one) => {
      if (one.kind === 'piece') {
        const image = foldImage(fold, one.map);
        return isSameFold(image, fold) ? [] : [{piece, fold: image}];
      }
      const isFirst = one.pieces[0] === name;
      const other = pieces.findIndex((each) => each.name === one.pieces[isFirst ? 1 : 0]);
      const image = foldImage(fold, one.map, isFirst ? 'image' : 'original');
      return other < 0 ? [] : [{piece: other, fold: image}];
    });
  }

  /** Mirror images of a fold that the garment has. */
  #alike(piece: number, fold: DraftedFold) {
    const {garment} = this;
    return this.#isMirrored && garment
      ? this.#images(piece, fold).filter((one) => foldLike(garment, one.piece, one.fold) >= 0)
      : [];
  }

  /** Each change is one step of the history. @param chosen fold that is selected afterwards */
  #take(
    before: GarmentDocument,
    edited: Edited,
    chosen: {readonly piece: number; readonly fold: DraftedFold} | undefined,
  ): void {
    const {design} = this.#workbench.history;
    const {pattern} = this.#workbench.solving;
    if (!design || !pattern) return;
    const {document} = edited;
    const {options, ...change} = designAfter(design, before, edited);
    const unmatched = [...new Set([...(options.unmatched ?? []), ...grownGathers(before, edited)])];
    const next = {...change, options: unmatched.length > 0 ? {...options, unmatched} : options};
    this.#workbench.edit(next, document, editedPattern(pattern, edited));
    const fold = chosen ? foldLike(document, chosen.piece, chosen.fold) : -1;
    this.#hovered = this.#cursor = undefined;
    this.#set(chosen && fold >= 0 ? {selected: {piece: chosen.piece, fold}} : {});
  }
}
