/** Effect of a press on the pattern: a choice for a symmetry, a move of a print, or a selection. */
import {
  choices,
  seamTarget,
  snap,
  targetsAt,
  type Target as Picked,
  type Snapped,
} from '../../clicks/pick.js';
import type {PickIndex} from '../../clicks/pick-index.js';
import type {Alignment, Point} from '../../model/geometry/vectors.js';
import {wayOnSheet} from '../../model/geometry/sheet-place.js';
import {notchMark} from '../../cutting/follow.js';
import type {Overlay} from '../../scene/overlay.js';
import type {PatternScene} from '../../scene/scene.js';
import type {Format} from '../../texts/format.js';
import {textsOf, type Texts} from '../../texts/texts.js';
import {withAll} from '../symmetry-steps.js';
import type {Target, Workbench} from '../workbench.js';
import {middleOf, pin, shifted, stepped, turnedOn, unpin} from './print-mover.js';
import type {GrainClicks} from './grain-clicks.js';
import {keepMarks, toggleKept} from './keeping.js';
import {railsOf} from './rails.js';
import type {FoldTool} from '../folding/fold-tool.js';
import type {SewingTool} from '../sewing/sewing-tool.js';
import {OnDemand, type EditingTool, type LaterTool, type Pointed} from '../later-tool.js';
import {toFailure} from '../latest-solve.js';
import {SymmetryChooser} from './symmetry-chooser.js';

/**
 * `axis`: a symmetric piece by two points, even near a line. `keep`: the pressed part stays as
 * drafted, or is released. `grain`: the grain line of a piece. `sew`: edges are sewn together.
 * `fold`: pleats, tucks and creases.
 */
export type Tool = 'piece' | 'axis' | 'pair' | OwnTool;
/** A tool that defines no symmetry. */
type OwnTool = 'move' | 'keep' | 'grain' | 'sew' | 'fold';

const ownTools: readonly Tool[] = ['move', 'keep', 'grain', 'sew', 'fold'];
/** Returns whether a tool changes the garment. */
const edits = (tool: Tool | undefined): boolean => tool === 'sew' || tool === 'fold';
/** Returns whether a tool is loaded at its first use. */
const isLater = (tool: Tool | undefined): boolean => edits(tool) || tool === 'grain';
const isOwn = (tool: Tool): tool is OwnTool => ownTools.includes(tool);

/** Greatest distance at which a pointer picks a line. [CSS px] */
export const reachOf = (pointerType: string): number => (pointerType === 'touch' ? 22 : 6);

/** Lines with a smaller difference in distance are equally likely. [CSS px] */
const tie = 2;

/** Factor of the reach for tools that pick lines first. */
const lineReach = 2;

export class PatternTools {
  readonly chooser: SymmetryChooser;
  /** True if there is one tool only, which is always active. */
  readonly isFixed: boolean;
  readonly #workbench: Workbench;
  readonly #changed: () => void;
  #own: OwnTool | undefined;
  readonly #sew: OnDemand<SewingTool>;
  readonly #fold: OnDemand<FoldTool>;
  readonly #grain: OnDemand<GrainClicks>;
  /** The sewing tool asks its questions as soon as it is loaded. */
  #asks = false;
  #byPoints = false;
  /** The part that a press would keep or release. */
  #pointed: Picked | undefined;
  #hovered: (Snapped & {readonly piece: number}) | undefined;

  /** @param purpose `place` has only the tool that moves the print */
  constructor(workbench: Workbench, changed: () => void, purpose: 'edit' | 'place' = 'edit') {
    this.isFixed = purpose === 'place';
    if (this.isFixed) this.#own = 'move';
    this.#workbench = workbench;
    this.#changed = changed;
    this.chooser = new SymmetryChooser(workbench, changed);
    const ready = (): void => {
      if (this.#asks) this.sewing?.chooser.ask();
      changed();
    };
    const failed = (error: unknown): void => {
      this.#own = undefined;
      workbench.notices.say({tone: 'error', text: toFailure(error).message});
      changed();
    };
    this.#sew = new OnDemand(
      async () => (await import('../sewing/sewing-tool.js')).sewingTool(workbench, changed),
      {ready, failed},
    );
    this.#fold = new OnDemand(
      async () => (await import('../folding/fold-tool.js')).foldTool(workbench, changed),
      {ready, failed},
    );
    this.#grain = new OnDemand(
      async () => new (await import('./grain-clicks.js')).GrainClicks(workbench, changed),
      {ready, failed},
    );
  }

  get active(): Tool | undefined {
    if (this.#own) return this.#own;
    const {tool} = this.chooser;
    return tool === 'piece' && this.#byPoints ? 'axis' : tool;
  }

  /**
   * True if the garment can be changed: one stored by its path stays as it is, unless it has no
   * seams at all.
   */
  get canSew(): boolean {
    const {design} = this.#workbench.history;
    const {garment} = this.#workbench.solving;
    return !design?.garment.file || garment?.seams.length === 0;
  }

  toggle(tool: Tool): void {
    if (this.isFixed || (edits(tool) && tool !== this.#own && !this.canSew)) return;
    this.#asks = false;
    if (isOwn(tool)) {
      this.chooser.leave();
      this.#grain.tool?.begin();
      this.#own = this.#own === tool ? undefined : tool;
    } else {
      this.#own = undefined;
      if (tool === this.active) this.chooser.leave();
      else this.chooser.send({type: 'start', tool: tool === 'pair' ? 'pair' : 'piece'});
      this.#byPoints = tool === 'axis';
    }
    this.#changed();
  }

  /** Starts the sewing tool for a garment without seams, with questions about likely seams. */
  beginSewing(): void {
    if (this.active !== 'sew') this.toggle('sew');
    this.#asks = true;
    this.sewing?.chooser.ask();
  }

  /** The sewing tool, if it is active and loaded. */
  get sewing(): SewingTool | undefined {
    return this.#own === 'sew' ? this.#sew.in(this.#language) : undefined;
  }

  /** The tool for folds, if it is active and loaded. */
  get folding(): FoldTool | undefined {
    return this.#own === 'fold' ? this.#fold.in(this.#language) : undefined;
  }

  /** True while a tool that changes the garment is active, even before it is loaded. */
  get isEditing(): boolean {
    return edits(this.#own);
  }

  /** The active tool that changes the garment, once it is loaded. */
  get editing(): EditingTool | undefined {
    return this.sewing ?? this.folding;
  }

  /** The active tool among those that are loaded at first use. */
  get #later(): LaterTool | undefined {
    return this.#own === 'grain' ? this.#grain.in(this.#language) : this.editing;
  }

  get #language(): string {
    return this.#workbench.preferences.chosen.language;
  }

  /** Undoes one step of the tool. @returns true if there was one */
  back(): boolean {
    const {active, isFixed} = this;
    if (isFixed) return false;
    if (this.#later?.back()) return true;
    if (this.#own) this.toggle(this.#own);
    else if (active) this.chooser.send({type: 'back'});
    return active !== undefined;
  }

  /** Imposes all found symmetries; shows a notice if the print can carry none of them. */
  acceptAll(): void {
    const {design} = this.#workbench.history;
    const {kept, found} = this.#workbench.solving;
    const preferences = this.#workbench.preferences.chosen;
    if (!design) return;
    const {group} = design.print;
    const symmetries = withAll(kept, group, found);
    if (symmetries.length === kept.length) {
      const {symmetry} = textsOf(preferences.language, preferences.messages);
      this.#workbench.notices.say({tone: 'info', text: symmetry.wouldCarry});
      return;
    }
    this.chooser.leave();
    this.#workbench.history.change({symmetry: symmetries});
  }

  words(texts: Texts, format: Format): string {
    if (this.#own === 'move') return texts.symmetry.moving;
    if (this.#own === 'keep') return texts.keep.hint;
    if (isLater(this.#own)) return this.#later?.words(texts, format) ?? '';
    return this.chooser.words(texts, format);
  }

  /** Returns the possible targets of a press: one, or several that are equally likely. */
  meant(index: PickIndex, at: Point, reach: number, scale: number): readonly Picked[] {
    if (edits(this.#own)) return targetsAt(index, at, (lineReach * reach) / scale).slice(0, 1);
    const targets = targetsAt(index, at, reach / scale);
    if (this.active === 'pair' || this.active === 'move') {
      const piece = targets.find(({kind}) => kind === 'piece') ?? targets[0];
      return piece ? [piece] : [];
    }
    return choices(targets, tie / scale);
  }

  /** Marks the point that a press would set; no mark if a press would not set a point. */
  hover(index: PickIndex, target: Picked | undefined, reachCm: number): void {
    if (isLater(this.#own)) {
      this.#later?.hover(target && this.#pointedBy(index, target, reachCm));
      return;
    }
    this.#pointed = this.#own === 'keep' ? target : undefined;
    const isPoint = this.active === 'axis' || (this.active === 'piece' && target?.kind === 'piece');
    const before = this.#hovered;
    this.#hovered =
      target && isPoint
        ? {piece: target.piece, ...this.#snapped(index, target, reachCm)}
        : undefined;
    if (before || this.#hovered || this.#own === 'keep') this.#changed();
  }

  #pointedBy(index: PickIndex, target: Picked, reachCm: number): Pointed {
    return {target, ...this.#snapped(index, target, reachCm), reachCm};
  }

  #snapped(index: PickIndex, {piece, point}: Picked, reachCm: number): Snapped {
    return snap(index, piece, point, reachCm, {notches: this.#notches(piece)});
  }

  /** Applies a press whose target is known. @param isMore adds the target to the choice */
  take(index: PickIndex, target: Picked, reachCm: number, isMore = false): void {
    if (isLater(this.#own)) {
      this.#later?.take(this.#pointedBy(index, target, reachCm), isMore);
      return;
    }
    if (this.chooser.tool) {
      const {point} = this.#snapped(index, target, reachCm);
      const {piece} = target;
      this.chooser.send(
        this.active === 'axis'
          ? {type: 'pickPoint', piece, point}
          : {type: 'pick', target, snapped: point},
      );
    }
    if (this.#own === 'keep') toggleKept(this.#workbench, target);
    this.#workbench.selection.select(
      target.kind === 'seam'
        ? {kind: 'seam', seam: target.seam, side: target.side}
        : {kind: 'piece', piece: target.piece},
    );
  }

  #notches(piece: number): readonly Point[] {
    const {scenes} = this.#workbench.sheet;
    const shown = scenes?.now.pieces[piece];
    const meshed = scenes?.now.pattern.pieces[piece];
    if (!shown || !meshed) return [];
    const {notches = []} = scenes.marks.get(shown.name) ?? {};
    return notches.flatMap((notch) => {
      const mark = notchMark({...meshed, shape: shown.points}, notch);
      return mark ? [mark.at] : [];
    });
  }

  /** Acts like a press on the selected part. */
  takeSelected(index: PickIndex): void {
    const {selected} = this.#workbench.selection;
    const target = selected && this.#targetOf(index, selected);
    if (!target) return;
    if (this.#own === 'keep') toggleKept(this.#workbench, target);
    else if (this.#own === 'grain') this.#later?.take(this.#pointedBy(index, target, 0), false);
    else if (this.chooser.tool) this.chooser.send({type: 'pick', target});
  }

  #targetOf(index: PickIndex, selected: Target): Picked | undefined {
    if (selected.kind === 'seam') return seamTarget(index, selected.seam, selected.side);
    const piece = this.#workbench.sheet.scenes?.now.pieces[selected.piece];
    return piece && {kind: 'piece', piece: selected.piece, point: middleOf(piece)};
  }

  /**
   * Moves the print of the selected piece by a vector on the sheet [cm], or turns it by degrees.
   */
  nudge(way: Point, degrees = 0): boolean {
    const {selected} = this.#workbench.selection;
    const {scenes} = this.#workbench.sheet;
    const piece = selected?.kind === 'piece' ? scenes?.now.pieces[selected.piece] : undefined;
    if (this.#own !== 'move' || !piece) return false;
    const wanted =
      degrees === 0
        ? stepped(this.#workbench, piece, wayOnSheet(piece, way))
        : turnedOn(this.#workbench, piece, degrees);
    if (wanted) pin(this.#workbench, piece, wanted);
    else {
      const {language, messages} = this.#workbench.preferences.chosen;
      const {cannotTurn} = textsOf(language, messages).symmetry;
      this.#workbench.notices.say({tone: 'info', text: cannotTurn(piece.label)});
    }
    return true;
  }

  /**
   * Starts to drag the print of a piece.
   * @returns a function that moves the print by a vector on the sheet [cm]
   */
  drag(scene: PatternScene, piece: number): ((way: Point) => void) | undefined {
    const dragged = scene.pieces[piece];
    if (this.#own !== 'move' || !dragged) return undefined;
    const from: Alignment = dragged.alignment;
    this.#workbench.selection.select({kind: 'piece', piece});
    return (way) => {
      pin(this.#workbench, dragged, shifted(from, wayOnSheet(dragged, way)));
    };
  }

  /** Unpins a moved print. */
  free(piece: number): void {
    const freed = this.#workbench.sheet.scenes?.now.pieces[piece];
    if (this.#own === 'move' && freed) unpin(this.#workbench, freed);
  }

  marks(scene: PatternScene, texts: Texts, format: Format): Overlay {
    if (this.#own === 'move') return railsOf(scene, this.#workbench.selection.selected, texts);
    if (isLater(this.#own)) return this.#later?.marks(scene, texts) ?? {};
    if (this.#own === 'keep') return keepMarks(this.#workbench, scene, this.#pointed, texts);
    const marks = this.chooser.marks(scene, texts, format);
    if (!this.#hovered || !this.chooser.tool) return marks;
    const {piece, point, snapped} = this.#hovered;
    const label = texts.symmetry.snaps[snapped];
    return {...marks, points: [...(marks.points ?? []), {piece, point, label}]};
  }
}

/** Returns the target to highlight. */
export const pointedAt = (target: Picked | undefined): Target | undefined => {
  if (!target) return undefined;
  if (target.kind === 'seam') return {kind: 'seam', seam: target.seam, side: target.side};
  return {kind: 'piece', piece: target.piece};
};
