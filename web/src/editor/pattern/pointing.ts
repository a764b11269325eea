/** Pointer events over the pattern: highlight, pick and drag. */
import type {PickIndex} from '../../clicks/pick-index.js';
import type {Target as Picked} from '../../clicks/pick.js';
import type {Point} from '../../model/geometry/vectors.js';
import type {PatternView} from '../../viewer/pattern-view.js';
import {holdWhilePressed} from '../base/hold.js';
import type {Workbench} from '../../workbench/workbench.js';
import {pointedAt, reachOf, type PatternTools} from '../../workbench/tools/pattern-tools.js';

/** The pane that receives pointer events. */
interface Pointable {
  readonly workbench: Workbench;
  readonly tools: PatternTools;
  readonly view: PatternView | undefined;
  readonly index: PickIndex | undefined;
  requestUpdate(): void;
}

/** Lines that a click may refer to, and its position. [CSS px] */
interface Ties {
  readonly at: Point;
  readonly targets: readonly Picked[];
}

export class Pointing {
  readonly #pane: Pointable;
  readonly #stage: HTMLElement;
  #ties: Ties | undefined;

  constructor(pane: Pointable, stage: HTMLElement, signal: AbortSignal) {
    this.#pane = pane;
    this.#stage = stage;
    const listen = <K extends keyof HTMLElementEventMap>(
      type: K,
      listener: (event: HTMLElementEventMap[K]) => void,
    ): void => {
      stage.addEventListener(type, listener, {signal});
    };
    listen('click', (event) => {
      this.#click(event);
    });
    listen('dblclick', (event) => {
      const pressed = pane.view?.pieceAt(...this.#at(event));
      if (pressed) pane.tools.free(pressed.piece);
    });
    listen('pointermove', (event) => {
      this.#hover(event);
    });
    listen('pointerleave', () => {
      pane.workbench.selection.point(undefined);
    });
  }

  /** The lines that the user has to choose from. */
  get ties(): Ties | undefined {
    return this.#ties;
  }

  forgetTies(): void {
    this.#ties = undefined;
    this.#pane.requestUpdate();
  }

  take(target: Picked, isMore = false): void {
    const {index, view, tools} = this.#pane;
    if (index && view) tools.take(index, target, reachOf('mouse') / view.scale, isMore);
    this.forgetTies();
  }

  /**
   * Starts to drag an end of the chosen edge, or the print inside a piece, if the tool allows it.
   * @returns true if a drag started
   */
  press(event: PointerEvent, at: Point): boolean {
    const {workbench, view, tools} = this.#pane;
    const reach = 2 * reachOf(event.pointerType);
    const grabbed =
      view && tools.sewing?.chooser.grab(view.sheetPointAt(...at), reach / view.scale);
    if (grabbed) {
      this.#follow(event, (to) => {
        grabbed.move(view.sheetPointAt(...to));
      }).addEventListener('abort', grabbed.drop);
      return true;
    }
    const pressed = view?.pieceAt(...at);
    const follow =
      workbench.sheet.scenes && pressed && tools.drag(workbench.sheet.scenes.now, pressed.piece);
    if (!view || !follow) return false;
    const [x, y] = view.sheetPointAt(...at);
    holdWhilePressed(workbench, event);
    this.#follow(event, (to) => {
      const [toX, toY] = view.sheetPointAt(...to);
      follow([toX - x, toY - y]);
    });
    return true;
  }

  /** Follows a pointer until it is lifted. @returns signal that aborts then */
  #follow({pointerId}: PointerEvent, moved: (to: Point) => void): AbortSignal {
    const done = new AbortController();
    const {signal} = done;
    this.#stage.setPointerCapture(pointerId);
    this.#stage.addEventListener(
      'pointermove',
      (move) => {
        moved(this.#at(move));
      },
      {signal},
    );
    for (const end of ['pointerup', 'pointercancel'] as const) {
      this.#stage.addEventListener(
        end,
        () => {
          done.abort();
        },
        {signal},
      );
    }
    return signal;
  }

  #at(event: MouseEvent): Point {
    const {left, top} = this.#stage.getBoundingClientRect();
    return [event.clientX - left, event.clientY - top];
  }

  #meant(event: MouseEvent, at: Point): readonly Picked[] {
    const {index, view, tools} = this.#pane;
    if (!index || !view) return [];
    const reach = reachOf(event instanceof PointerEvent ? event.pointerType : 'mouse');
    return tools.meant(index, view.sheetPointAt(...at), reach, view.scale);
  }

  #click(event: MouseEvent): void {
    const at = this.#at(event);
    const targets = this.#meant(event, at);
    const [first] = targets;
    this.#ties = targets.length > 1 ? {at, targets} : undefined;
    if (!first) this.#pane.workbench.selection.select(undefined);
    else if (targets.length === 1) this.take(first, event.shiftKey);
    this.#pane.requestUpdate();
  }

  #hover(event: PointerEvent): void {
    if (event.pointerType === 'touch' || event.buttons > 0) return;
    const [target] = this.#meant(event, this.#at(event));
    const {index, view, tools, workbench} = this.#pane;
    if (index && view) tools.hover(index, target, reachOf('mouse') / view.scale);
    workbench.selection.point(tools.editing ? undefined : pointedAt(target)); // these tools have own marks
  }
}
