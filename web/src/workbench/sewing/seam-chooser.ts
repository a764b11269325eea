/** Clicks and keys that sew a garment, from the first edge to the steps of the history. */
import type {Target as Picked} from '../../clicks/pick.js';
import {
  afterEvent,
  nothingChosen,
  questionOf,
  type Candidate,
  type Question,
  type SeamEdit,
  type SeamEvent,
  type SeamState,
  type Sewing,
} from '../../clicks/seam-tool.js';
import type {DesignGarment} from '../../model/design/design.js';
import {designAfter} from '../../model/design/edited-design.js';
import {edgeLength} from '../../model/garment/edge-curve.js';
import type {EdgeOfPiece} from '../../model/garment/garment-document.js';
import {edgeOf, isOpen, sameEdge, seamAt} from '../../model/garment/edits.js';
import {distance, type Point} from '../../model/geometry/vectors.js';
import {offSheet, ontoSheet} from '../../model/geometry/sheet-place.js';
import type {Run} from '../../clicks/run.js';
import {nearestOn, pathThrough} from '../../clicks/path.js';
import {edgePoints, type Overlay} from '../../scene/overlay.js';
import type {PatternScene} from '../../scene/scene.js';
import {formatFor, type Format} from '../../texts/format.js';
import type {SewTexts} from '../../texts/sew-texts.js';
import {withSampleNames} from '../../texts/sample-names.js';
import {textsOf, type Texts} from '../../texts/texts.js';
import {lastOf} from '../../model/base/last-of.js';
import type {Workbench} from '../workbench.js';
import {EdgeNames, editedPattern, nearestNotch} from '../../sewing/edited-pattern.js';
import {editedBy, newGathers} from '../../sewing/seam-edits.js';
import {partMarks, seamMarks, type Part} from '../../sewing/seam-marks.js';
import {seamPicture, type SeamPicture} from '../../sewing/seam-picture.js';
import {countWords, edgeWords, seamWords, type Speech} from '../../sewing/seam-words.js';
import {sewingOf} from '../../sewing/sewing.js';

/** Greatest distance at which a pointer snaps to a notch. [cm] */
const notchReach = 1;
/** Least part that can be split off, as a share. */
const leastPart = 0.02;
const within = (share: number): number => Math.max(leastPart, Math.min(1 - leastPart, share));

/** An edge under the pointer, and the share of it before the pointer. */
interface Hovered {
  readonly edge: EdgeOfPiece;
  readonly share: number;
}

/** A drag of an end of an edge, in points of the sheet. */
interface Grabbed {
  readonly move: (to: Point) => void;
  readonly drop: () => void;
}

export class SeamChooser {
  readonly #workbench: Workbench;
  readonly #changed: () => void;
  readonly #sew: SewTexts;
  readonly #sewing = lastOf(sewingOf);
  readonly #names = lastOf(
    (...given: ConstructorParameters<typeof EdgeNames>) => new EdgeNames(...given),
  );
  readonly #picture = lastOf(seamPicture);
  #latest = nothingChosen;
  /** The garment that `#latest` belongs to. */
  #garment: DesignGarment | undefined;
  #hovered: Hovered | undefined;
  /** The part that the present drag would split off. */
  #part: Part | undefined;
  /** True from the end of a drag to the next press. */
  #isDropped = false;

  constructor(workbench: Workbench, sew: SewTexts, changed: () => void) {
    this.#workbench = workbench;
    this.#sew = sew;
    this.#changed = changed;
  }

  /** Texts of the sewing tool. */
  get sew(): SewTexts {
    return this.#sew;
  }

  /** Choices for one garment are not valid for another, such as after an undo. */
  get state(): SeamState {
    const garment = this.#workbench.history.design?.garment;
    if (garment !== this.#garment) {
      const isSame = this.#latest.suggests && garment?.name === this.#garment?.name;
      const {suggests, answered, later, log} = this.#latest;
      // a seam that the history took back was the last *yes*
      const last = log.lastIndexOf('yes');
      this.#latest = {
        ...nothingChosen,
        ...(isSame && {suggests, answered, later, log: log.filter((_, k) => k !== last)}),
      };
      this.#garment = garment;
      this.#hovered = undefined;
    }
    return this.#latest;
  }

  /** Undefined until the garment has been read. */
  get sewing(): Sewing | undefined {
    const {garment} = this.#workbench.solving;
    return garment && this.#sewing(garment, this.state.answered);
  }

  get question(): Question | undefined {
    const {sewing} = this;
    return sewing && questionOf(this.state, sewing);
  }

  /** Possible partners of the run, chosen by number. */
  get candidates(): readonly Candidate[] {
    const {sewing, isSewn} = this;
    return sewing && !isSewn ? sewing.candidates(this.state.run) : [];
  }

  /** True if the chosen edge is sewn. */
  get isSewn(): boolean {
    const [first] = this.state.run;
    const {sewing} = this;
    return (
      first !== undefined && sewing !== undefined && seamAt(sewing.garment, first) !== undefined
    );
  }

  get isOpen(): boolean {
    const {sewing} = this;
    return this.state.run.some((edge) => sewing && isOpen(edgeOf(sewing.garment, edge)));
  }

  /** @returns true if the tool stays active */
  send(event: SeamEvent): boolean {
    const {sewing, state} = this;
    if (!sewing) return true;
    const answer = afterEvent(state, event, sewing);
    if (!answer) return false;
    this.#latest = answer.state;
    if (answer.edit) this.#take(answer.edit, sewing);
    this.#changed();
    return true;
  }

  /** Progress of the questions: the number of the present one, and that of all. */
  get progress(): {readonly present: number; readonly all: number} | undefined {
    const {sewing, question, state} = this;
    if (!sewing || question?.kind !== 'seam') return undefined;
    const answers = state.log.filter((answer) => answer !== 'skip').length;
    return {present: answers + 1, all: answers + sewing.questions().length};
  }

  /** The sides of the seam in question, face to face. */
  get picture(): SeamPicture | undefined {
    const {sewing, question} = this;
    return sewing && question?.kind === 'seam'
      ? this.#picture(sewing.garment, question)
      : undefined;
  }

  /** Names of the pieces on both sides of the seam in question. */
  get sides(): readonly string[] {
    const {sewing, question} = this;
    if (!sewing || question?.kind !== 'seam') return [];
    const {names} = this.#own(sewing);
    return [question.a, question.b].map((run) => names.piecesOf(run));
  }

  /** Starts the questions, unless they are open already. */
  ask(): void {
    if (!this.state.suggests) this.send({type: 'suggest'});
  }

  /** Takes the last answer back. */
  unanswer(): void {
    const {log} = this.state;
    if (log.at(-1) === 'yes') this.#workbench.history.undo();
    else this.send({type: 'unanswer'});
  }

  /** Each change is one separate step of the history. */
  #take(edit: SeamEdit, {garment: before}: Sewing): void {
    const {design} = this.#workbench.history;
    const {pattern} = this.#workbench.solving;
    if (!design || !pattern) return;
    if (edit.kind === 'match') {
      const unmatched = design.options.unmatched?.filter((seam) => !edit.seams.includes(seam));
      this.#workbench.history.change({options: {...design.options, ...(unmatched && {unmatched})}});
      return;
    }
    const edited = editedBy(before, edit);
    const {document, edgesOf} = edited;
    const isSewing = edit.kind === 'sew' || edit.kind === 'sewAll';
    const gathered = isSewing ? newGathers(before, document) : [];
    // the question of a whole seam gives its ease, so that gathers need no further one
    const isAsked = edit.kind === 'sewAll' && edit.exactly === true;
    const {options, ...change} = designAfter(design, before, edited);
    const unmatched = [...(options.unmatched ?? []), ...gathered];
    const next = {...change, options: gathered.length > 0 ? {...options, unmatched} : options};
    this.#garment = next.garment;
    this.#hovered = undefined;
    this.#workbench.edit(next, document, editedPattern(pattern, edited));
    const kept = edit.kind === 'split' ? {keeps: edit.keeps} : {};
    const event = {
      ...({type: 'edited', edgesOf} as const),
      ...{gathered: isAsked ? [] : gathered, ...kept},
    };
    const answer = afterEvent(this.#latest, event, this.#sewing(document, []));
    if (answer) this.#latest = answer.state;
  }

  /** Applies a press. @param isMore adds the edge to the same side */
  take(target: Picked, isMore: boolean): void {
    if (this.#isDropped) return; // this click ends a drag
    if (target.kind === 'piece' || target.edge === undefined) return;
    const edge = {piece: target.piece, edge: target.edge};
    this.send({type: 'pick', edge, extends: isMore});
  }

  /** Updates the edge under the pointer. */
  hover(target: Picked | undefined): void {
    const before = this.#hovered;
    this.#hovered = target && this.#under(target);
    if (before !== this.#hovered) this.#changed();
  }

  #under(target: Picked): Hovered | undefined {
    const shown = this.#workbench.sheet.scenes?.now.pieces[target.piece];
    if (!shown || target.kind === 'piece' || target.edge === undefined) return undefined;
    const edge = {piece: target.piece, edge: target.edge};
    return {edge, share: shareAt(edgePoints(shown, edge.edge), target.point)};
  }

  /**
   * Splits the chosen edge at the pointer, or at a notch near the pointer. If the pointer is
   * elsewhere, it splits at the notch nearest to the middle, or else in the middle.
   */
  split(): void {
    const {sewing} = this;
    const [edge = this.#hovered?.edge] = this.state.run;
    if (!sewing || !edge) return;
    const pointed = this.#hovered && sameEdge(this.#hovered.edge, edge) ? this.#hovered : undefined;
    const middle = nearestNotch(sewing.garment, edge, 0.5) ?? 0.5;
    const share = pointed ? this.#near(edge, pointed.share) : middle;
    this.send({type: 'split', edge, share: within(share), keeps: 0});
  }

  /**
   * Starts to drag an end of the chosen edge along the edge, so that a part of it can be sewn.
   * @param at point on the sheet
   * @param reach greatest distance from the end [cm]
   * @returns functions that move and end the drag
   */
  grab(at: Point, reach: number): Grabbed | undefined {
    this.#isDropped = false;
    const {run} = this.state;
    const [edge] = run;
    const shown = edge && this.#workbench.sheet.scenes?.now.pieces[edge.piece];
    if (!shown || run.length !== 1 || this.isSewn) return undefined;
    const line = edgePoints(shown, edge.edge);
    const isAt = (end: Point | undefined): boolean =>
      end !== undefined && distance(ontoSheet(shown, end), at) < reach;
    const isEnd = isAt(line.at(-1));
    if (!isEnd && !isAt(line[0])) return undefined;
    const keeps = isEnd ? 0 : 1;
    return {
      move: (to) => {
        const share = this.#near(edge, shareAt(line, offSheet(shown, to)));
        this.#part = {edge, share: within(share), keeps};
        this.#changed();
      },
      drop: () => {
        const part = this.#part;
        this.#part = undefined;
        this.#isDropped = part !== undefined;
        if (part) this.send({type: 'split', ...part});
      },
    };
  }

  /** Returns a position on an edge, or that of a notch near it. */
  #near(edge: EdgeOfPiece, share: number): number {
    const garment = this.sewing?.garment;
    const drafted = garment && edgeOf(garment, edge);
    const notch = garment && nearestNotch(garment, edge, share);
    if (!drafted || notch === undefined) return share;
    return Math.abs(notch - share) * edgeLength(drafted) < notchReach ? notch : share;
  }

  /**
   * Moves to the next edge of the garment or of the piece, or to the first edge of the next piece.
   * @returns true if there is one
   */
  walk(by: 1 | -1, within: 'all' | 'piece' | 'pieces'): boolean {
    const {sewing, state} = this;
    if (!sewing) return false;
    const {order, garment} = sewing;
    const present = state.other[0] ?? state.run[0];
    if (!present) {
      const start = by > 0 ? order[0] : order.at(-1);
      if (start) this.send({type: 'go', edge: start});
      return start !== undefined;
    }
    const {piece} = present;
    const count = garment.pieces[piece]?.outline.length ?? 1;
    const pieces = garment.pieces.length;
    const at = order.findIndex((edge) => sameEdge(edge, present));
    const next: EdgeOfPiece | undefined = {
      all: order[at + by],
      piece: {piece, edge: (present.edge + by + count) % count},
      pieces: {piece: (piece + by + pieces) % pieces, edge: 0},
    }[within];
    if (next) this.send({type: 'go', edge: next});
    else this.send({type: 'back'});
    return next !== undefined;
  }

  marks(scene: PatternScene): Overlay {
    const {sewing, state} = this;
    if (!sewing) return {};
    return this.#part
      ? partMarks(sewing, scene, this.#part, this.#own(sewing).format)
      : seamMarks(state, sewing, scene, this.#hovered?.edge);
  }

  words(texts: Texts, format: Format): string {
    const {sewing} = this;
    return sewing ? seamWords(this.state, sewing, this.#speech(sewing, texts, format)) : '';
  }

  countWords(): string {
    const {sewing} = this;
    return sewing ? countWords(sewing, this.#sew) : '';
  }

  /** Returns all edges as text, in their order. */
  options(): readonly {readonly edge: EdgeOfPiece; readonly text: string}[] {
    const {sewing} = this;
    if (!sewing) return [];
    const speech = this.#own(sewing);
    return sewing.order.map((edge) => ({edge, text: edgeWords(sewing, [edge], speech)}));
  }

  nameOf(run: Run): string {
    return this.sewing ? this.#own(this.sewing).names.ofRun(run) : '';
  }

  #own(sewing: Sewing): Speech {
    const {language, messages, units} = this.#workbench.preferences.chosen;
    return this.#speech(sewing, textsOf(language, messages), formatFor(language, units));
  }

  #speech({garment}: Sewing, texts: Texts, format: Format): Speech {
    const scene = this.#workbench.sheet.scenes?.now ?? {pieces: []};
    const {history, preferences} = this.#workbench;
    const {language} = preferences.chosen;
    const named = withSampleNames(garment, history.design?.garment.name ?? '', texts);
    const names = this.#names(named, scene, texts, this.#sew, language);
    return {names, sew: this.#sew, format, places: texts.places};
  }
}

/** Returns the share of a line before the place on it that is nearest to a point. */
function shareAt(line: readonly Point[], point: Point): number {
  const path = pathThrough(line);
  return (nearestOn(path, point)?.along ?? 0) / (path.length || 1);
}
