/** The element's events: fired once for each change; events of its parts stay inside. */
import {failureOf, SolverError, type Failure} from '../../model/base/failure.js';
import type {Progress} from '../../model/design/solve-problem.js';
import type {Target, Workbench} from '../../workbench/workbench.js';
import type {GarmentEvents} from './events.js';
import type {Loaded} from './sources.js';
import {drapeEvent, drawnEvent, undrawableEvent} from '../../editor/pattern/scene-drawing.js';
import {toFailure} from '../../workbench/latest-solve.js';

/** Inner events that would leave the element as if they were its own. */
const kept = ['input', 'change', 'select', 'sw-lens-cursor', 'sw-lens-wanted'];

interface InnerListener {
  readonly draped: (news: GarmentEvents['drape']) => void;
  readonly drawn: () => void;
  readonly undrawable: (failure: Failure) => void;
}

/** Keeps these events within a shadow root, and handles those about the drawing. */
export function keepInside(root: EventTarget, {draped, drawn, undrawable}: InnerListener): void {
  for (const type of [...kept, drapeEvent, drawnEvent, undrawableEvent]) {
    root.addEventListener(type, (event) => {
      event.stopPropagation();
    });
  }
  root.addEventListener(drapeEvent, (event) => {
    draped((event as CustomEvent<GarmentEvents['drape']>).detail);
  });
  root.addEventListener(drawnEvent, drawn);
  root.addEventListener(undrawableEvent, (event) => {
    undrawable((event as CustomEvent<Failure>).detail);
  });
}

/** Converts any error to the element's only kind of error. */
export function asError(error: unknown): SolverError {
  if (error instanceof SolverError) return error;
  return new SolverError(toFailure(error));
}

export type Emit = <K extends keyof GarmentEvents>(type: K, detail: GarmentEvents[K]) => void;

/** Fires events for changes of a workbench, each change once. */
export class Announcer {
  readonly #emit: Emit;
  readonly #spoken: (failure: Failure) => SolverError;
  #wasSolving = false;
  #progress = '';
  #selected: Target | undefined;

  /** @param spoken converts a failure of the core to an error in the user's language */
  constructor(emit: Emit, spoken: (failure: Failure) => SolverError) {
    this.#emit = emit;
    this.#spoken = spoken;
  }

  failed(error: SolverError): void {
    this.#emit('error', failureOf(error));
  }

  loaded({garment, print}: Loaded): void {
    this.#emit('load', {
      garment: {name: garment.name, url: garment.file?.url ?? null},
      print: {name: print.title, url: print.file?.place?.url ?? null},
    });
    this.#wasSolving = false;
  }

  /** Reports the progress of a solve, and its end. */
  solved({solving: {state, result}, running: {progress}}: Workbench): void {
    if (state.kind === 'solving') {
      this.#wasSolving = true;
      this.progress(progress);
    } else if (this.#wasSolving) {
      this.#wasSolving = false;
      if (state.kind === 'failed') this.failed(this.#spoken(state.failure));
      if (state.kind === 'done' && result) {
        this.progress({phase: 'deformation', fraction: 1});
        const {metrics} = result;
        this.#emit('solve', {metrics, milliseconds: metrics.milliseconds.total});
      }
    }
  }

  selected({selection: {selected}, solving: {pattern}}: Workbench): void {
    if (selected === this.#selected) return;
    this.#selected = selected;
    const pieceAt = (k: number): string | null => pattern?.pieces[k]?.name ?? null;
    if (!selected) {
      this.#emit('select', {kind: 'none', piece: null, seam: null});
    } else if (selected.kind === 'piece') {
      this.#emit('select', {kind: 'piece', piece: pieceAt(selected.piece), seam: null});
    } else {
      const {seam, side} = selected;
      const piece = pieceAt(pattern?.seams[seam]?.[side].piece ?? -1);
      this.#emit('select', {kind: 'seam', piece, seam});
    }
  }

  progress({phase, fraction}: Progress): void {
    const progress = `${phase} ${fraction}`;
    if (progress === this.#progress) return;
    this.#progress = progress;
    this.#emit('progress', {phase, fraction});
  }
}
