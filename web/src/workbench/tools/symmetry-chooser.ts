/** Clicks that define a symmetry, from the first click to the step of the history. */
import {
  afterEvent,
  outlived,
  outside,
  type Choice,
  type SymmetryEvent,
  type SymmetryState,
  type SymmetryTool,
} from '../../clicks/symmetry-tool.js';
import type {Design} from '../../model/design/design.js';
import type {GroupName} from '../../model/print/repeating-print.js';
import {carries} from '../../model/print/repeat.js';
import type {MeasuredSymmetry, Symmetry} from '../../model/garment/symmetries.js';
import {axisAlong, pick} from '../../scene/marks.js';
import type {Overlay} from '../../scene/overlay.js';
import {symmetriesOf} from '../../scene/scene-marks.js';
import type {PatternScene} from '../../scene/scene.js';
import type {Format} from '../../texts/format.js';
import {textsOf, type Texts} from '../../texts/texts.js';
import {withSymmetry} from '../symmetry-steps.js';
import {spokenFailure} from '../spoken-failure.js';
import {toFailure} from '../latest-solve.js';
import type {Workbench} from '../workbench.js';

export class SymmetryChooser {
  readonly #workbench: Workbench;
  readonly #changed: () => void;
  #latest: SymmetryState = outside;
  /** The design that `#latest` belongs to. */
  #design: Design | undefined;

  constructor(workbench: Workbench, changed: () => void) {
    this.#workbench = workbench;
    this.#changed = changed;
  }

  /** A refusal is valid for one design only, and choices for one garment only. */
  get #state(): SymmetryState {
    const {design} = this.#workbench.history;
    if (design !== this.#design) {
      this.#latest = outlived(this.#latest, design?.garment === this.#design?.garment);
      this.#design = design;
    }
    return this.#latest;
  }

  get tool(): SymmetryTool | undefined {
    return this.#state.stage === 'outside' ? undefined : this.#state.tool;
  }

  /** True if both choices are valid, so that the user can accept the symmetry. */
  get isReady(): boolean {
    const state = this.#state;
    return (
      state.stage === 'candidate' && state.measured !== undefined && this.#isCarried(state.tool)
    );
  }

  get #group(): GroupName {
    return this.#workbench.history.design?.print.group ?? 'p1';
  }

  /** Returns whether the print has the symmetry that the tool requires. */
  #isCarried(tool: SymmetryTool): boolean {
    return carries(this.#group, tool);
  }

  leave(): void {
    this.#set({stage: 'outside', asked: this.#state.asked});
  }

  send(event: SymmetryEvent): void {
    const scene = this.#workbench.sheet.scenes?.now;
    if (!scene) return;
    const next = afterEvent(this.#state, event, scene);
    if (next === this.#state) return;
    this.#set(next);
    if (next.stage === 'candidate' && !next.measured) void this.#measure(next.symmetry, next.asked);
    if (next.stage === 'committed') {
      this.#workbench.history.change(withSymmetry(this.#workbench.solving.kept, next.symmetry));
      this.#set({stage: 'idle', tool: next.tool, asked: next.asked});
    }
  }

  async #measure(symmetry: Symmetry, candidate: number): Promise<void> {
    try {
      const result = await this.#workbench.solving.measure(symmetry);
      this.send({type: 'measured', candidate, result});
    } catch (error) {
      const {language, messages} = this.#workbench.preferences.chosen;
      const text = spokenFailure(toFailure(error), this.#workbench, textsOf(language, messages));
      this.#workbench.notices.say({tone: 'error', text});
      this.send({type: 'back'});
    }
  }

  #set(state: SymmetryState): void {
    this.#latest = state;
    this.#design = this.#workbench.history.design;
    this.#changed();
  }

  /** Returns the next instruction, or the finding. */
  words(texts: Texts, format: Format): string {
    const {symmetry} = texts;
    const state = this.#state;
    switch (state.stage) {
      case 'outside':
        return '';
      case 'idle':
      case 'committed':
        return symmetry.begin[state.tool];
      case 'chosen':
        return symmetry.next[state.first.kind];
      case 'refused':
        return state.measured
          ? symmetry.noMirror(format.fine(state.measured.residual))
          : symmetry.refusals[state.reason];
      case 'candidate': {
        if (!state.measured) return symmetry.measuring;
        if (!this.#isCarried(state.tool)) return symmetry.notCarried;
        return symmetry.found[state.tool](format.fine(state.measured.residual));
      }
    }
  }

  /** Returns marks on the pattern for the choices. */
  marks(scene: PatternScene, texts: Texts, format: Format): Overlay {
    const state = this.#state;
    if (state.stage === 'outside' || state.stage === 'idle' || state.stage === 'committed')
      return {};
    const choices = [
      ...(state.first ? [state.first] : []),
      ...('second' in state ? [state.second] : []),
    ];
    const marks: Overlay = {
      points: choices.flatMap(({kind, piece, point}) => (kind === 'line' ? [] : [{piece, point}])),
      lines: choices.flatMap((choice) => lineOf(scene, choice)),
    };
    if (state.stage === 'refused') {
      const text = this.words(texts, format);
      return {...marks, message: {...state.at, text, tone: 'error'}};
    }
    if (state.stage !== 'candidate' || !state.measured) return marks;
    return {...marks, ...candidateMarks(scene, state.symmetry, state.measured)};
  }
}

/** Returns the chosen edge on the sheet. */
function lineOf(scene: PatternScene, choice: Choice): NonNullable<Overlay['lines']> {
  const piece = scene.pieces[choice.piece];
  if (choice.kind !== 'line' || !piece?.edges) return [];
  const {edges, outline, points} = piece;
  const vertices = outline.flatMap((from, k) =>
    edges[k] === choice.edge ? [from, outline[(k + 1) % outline.length] ?? from] : [],
  );
  return [{piece: choice.piece, line: pick(points, vertices)}];
}

/** Returns the candidate as the scene would draw it if it were imposed: an axis, or two letters. */
function candidateMarks(
  scene: PatternScene,
  symmetry: Symmetry,
  {map}: Pick<MeasuredSymmetry, 'map'>,
): Overlay {
  const number = (name: string): number => scene.pieces.findIndex((piece) => piece.name === name);
  if (symmetry.kind === 'piece') {
    const piece = number(symmetry.piece);
    const {points = [], outline = []} = scene.pieces[piece] ?? {};
    return {candidate: {piece, axis: axisAlong(map, pick(points, outline), 3)}};
  }
  const pieces = [number(symmetry.pieces[0]), number(symmetry.pieces[1])] as const;
  const symmetries = [{kind: 'pair', pieces, map, pairs: []}] as const;
  return {ghosts: symmetriesOf({...scene.pattern, symmetries}, scene.outline)};
}
