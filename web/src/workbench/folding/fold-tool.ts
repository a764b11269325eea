/** The tool for folds with its texts, marks and keys; loaded on demand. */
import {placeAt, nearestOn as placeOn} from '../../clicks/path.js';
import type {PickIndex} from '../../clicks/pick-index.js';
import {draftedPoint} from '../../clicks/sheet.js';
import {foldKinds} from '../../model/garment/garment-document.js';
import {hidesFabric} from '../../model/garment/folds.js';
import {middle} from '../../model/geometry/vectors.js';
import {shownArrows} from '../../scene/fold-arrows.js';
import {onShown, shownFold} from '../../scene/folds.js';
import type {OnPiece, Overlay} from '../../scene/overlay.js';
import type {PatternScene} from '../../scene/scene.js';
import {uptakeOf} from '../../sewing/fold-places.js';
import {loadFoldTexts, type FoldTexts} from '../../texts/fold-texts.js';
import {formatFor, type Format} from '../../texts/format.js';
import type {Texts} from '../../texts/texts.js';
import type {EditingTool, Pointed} from '../later-tool.js';
import type {Workbench} from '../workbench.js';
import {FoldChooser, type Spot} from './fold-chooser.js';

/** Steps of the arrow keys along an outline. [cm] */
const coarseStep = 1;
const fineStep = 0.1;

/** Length of an arrowhead as a share of the fabric in the pleat, and its greatest length. [cm] */
const headShare = 0.3;
const longestHead = 2.5;

type Lines = NonNullable<Overlay['lines']>;

export class FoldTool implements EditingTool {
  readonly chooser: FoldChooser;
  readonly texts: FoldTexts;
  readonly #workbench: Workbench;

  constructor(workbench: Workbench, texts: FoldTexts, changed: () => void) {
    this.#workbench = workbench;
    this.texts = texts;
    this.chooser = new FoldChooser(workbench, changed);
  }

  hover(at: Pointed | undefined): void {
    this.chooser.hover(at);
  }

  take(at: Pointed): void {
    this.chooser.take(at);
  }

  back(): boolean {
    return this.chooser.back();
  }

  get keys() {
    return this.texts.keys;
  }

  title({folding}: Texts): string {
    return folding.tool;
  }

  /** Name of a piece for the user. */
  #label(piece: number | undefined): string {
    return this.#workbench.sheet.scenes?.now.pieces[piece ?? -1]?.label ?? '';
  }

  words(_: Texts, format: Format): string {
    const {texts, chooser} = this;
    const {first, selected, refused} = chooser.state;
    const way = hidesFabric(chooser) ? 'pleat' : 'crease';
    const {fold, cursor} = chooser;
    if (refused) return texts.refusals[refused];
    if (fold) {
      const [kind, piece] = [texts.kinds[fold.kind], this.#label(selected?.piece)];
      const said = hidesFabric(fold)
        ? texts.chosen(kind, piece, format.length(uptakeOf(fold)))
        : texts.chosenCrease(kind, piece);
      return `${said} ${texts.edit}`;
    }
    const next = first ? texts.next[way] : texts.begin[way];
    return cursor ? `${next} ${texts.cursor(this.#label(cursor.piece))}` : next;
  }

  marks(scene: PatternScene): Overlay {
    const {garment, state, fold, preview, pointed} = this.chooser;
    const arrows = (garment?.pieces ?? []).flatMap(({folds = []}, piece): Lines =>
      folds.flatMap((one) => shownArrows(scene, piece, one, {head: headOf(one)})),
    );
    const piece = state.selected?.piece ?? state.first?.piece ?? pointed?.piece ?? -1;
    const chosen = fold
      ? [
          ...shownFold(scene, piece, fold, 'chosen'),
          ...shownArrows(scene, piece, fold, {head: headOf(fold), look: 'chosen'}),
        ]
      : [];
    const shown = preview
      ? [
          ...shownFold(scene, piece, preview, 'lit'),
          ...shownArrows(scene, piece, preview, {head: headOf(preview), look: 'chosen'}),
        ]
      : [];
    const points = [state.first, pointed].flatMap((spot) => (spot ? [spot] : []));
    return {
      lines: [...arrows, ...shown, ...chosen],
      points: [...points, ...this.#widthOf(scene, piece)],
    };
  }

  /** The fabric between the lines of the fold that the next press would make. */
  #widthOf(scene: PatternScene, piece: number): readonly (OnPiece & {readonly label: string})[] {
    const {line, to} = this.chooser.preview ?? {};
    if (!line || !to) return [];
    const {language, units} = this.#workbench.preferences.chosen;
    const label = this.texts.between(formatFor(language, units).length(uptakeOf({line, to})));
    return [{piece, point: onShown(scene, piece, middle(middle(...line), middle(...to))), label}];
  }

  press(event: KeyboardEvent, index: PickIndex | undefined): boolean {
    const {chooser} = this;
    const {key, shiftKey} = event;
    if (key === 'Tab') return chooser.walk(shiftKey ? -1 : 1);
    if (/^[1-6]$/.test(key)) {
      const kind = foldKinds[Number(key) - 1];
      if (kind) chooser.setKind(kind);
      return true;
    }
    if (chooser.fold && (key === 'Delete' || key === 'Backspace')) chooser.remove();
    else if (chooser.fold && key.toLowerCase() === 'r') chooser.reverse();
    else if (key === 'Enter' || key === ' ') return this.#enter(index);
    else return index !== undefined && this.#move(index, key, shiftKey ? fineStep : coarseStep);
    return true;
  }

  /** Sets the place that the keys move, or shows it on the selected piece. */
  #enter(index: PickIndex | undefined): boolean {
    const {chooser} = this;
    const {cursor, state} = chooser;
    if (cursor) {
      chooser.set(cursor);
      if (chooser.state.first) chooser.moveCursor(cursor);
      return true;
    }
    const {selected} = this.#workbench.selection;
    const piece = state.first?.piece ?? (selected?.kind === 'piece' ? selected.piece : undefined);
    const parts = piece === undefined ? undefined : index?.pieces[piece];
    if (!index || piece === undefined || !parts) return false;
    const isHigher = ([, y]: readonly number[], [, z]: readonly number[]): number =>
      (z ?? 0) - (y ?? 0);
    const [top] = [...parts.midpoints].sort(isHigher);
    const start = top && placeOn(parts.outline, top);
    chooser.moveCursor(this.#spotAt(index, piece, start?.along ?? 0));
    return true;
  }

  #move(index: PickIndex, key: string, step: number): boolean {
    const {cursor} = this.chooser;
    const parts = cursor && index.pieces[cursor.piece];
    const present = cursor && parts && placeOn(parts.outline, cursor.point);
    if (!cursor || !parts || !present) return false;
    const whole = parts.outline.length;
    const by = {ArrowLeft: -1, ArrowRight: 1}[key];
    const side = {ArrowUp: -1, ArrowDown: 1}[key];
    if (by !== undefined) {
      this.chooser.moveCursor(this.#spotAt(index, cursor.piece, present.along + by * step));
      return true;
    }
    if (side === undefined) return false;
    const gaps = [...parts.corners, ...parts.midpoints].flatMap((mark) => {
      const at = placeOn(parts.outline, mark);
      const gap = at ? (side * (at.along - present.along) + whole) % whole : 0;
      return gap > fineStep / 2 ? [gap] : [];
    });
    const next = present.along + side * Math.min(...gaps, whole);
    this.chooser.moveCursor(this.#spotAt(index, cursor.piece, next));
    return true;
  }

  /** A place on the outline of a piece at a length from its start. [cm] */
  #spotAt(index: PickIndex, piece: number, along: number): Spot | undefined {
    const {outline} = index.pieces[piece] ?? {};
    const whole = outline?.length ?? 0;
    const at = outline && placeAt(outline, (along + whole) % whole);
    const scene = this.#workbench.sheet.scenes?.now;
    if (!at || !scene) return undefined;
    return {piece, point: at.point, place: {point: draftedPoint(scene, piece, at.point)}};
  }
}

const headOf = (fold: Parameters<typeof uptakeOf>[0]): number =>
  Math.min(longestHead, headShare * uptakeOf(fold));

/** Loads the texts and makes the tool. @throws {Error} if there is no network */
export async function foldTool(workbench: Workbench, changed: () => void): Promise<FoldTool> {
  const {language, messages} = workbench.preferences.chosen;
  return new FoldTool(workbench, await loadFoldTexts(language, messages), changed);
}
