/** Drags pieces over the fabric and draws flaws by pointer. */
import type {Bolt} from '../../marker/places.js';
import {minus, type Alignment, type Point} from '../../model/geometry/vectors.js';
import type {PieceOnFabric} from '../../workbench/marker/marker-work.js';
import {FlawTool} from '../../clicks/flaw-tool.js';
import {PieceDrag, type Dragged} from '../../workbench/marker/piece-drag.js';
import {offSheet, type SheetFrame} from '../../marker/sheet-frame.js';

/** A shorter movement is a click. [CSS px] */
const leastWay = 4;
/** Time per frame for finding free places. [ms] */
const lookTime = 4;

/** The view that receives pointer events. */
export interface PointedFabric {
  readonly isReady: boolean;
  readonly shown: {
    readonly pieces: readonly PieceOnFabric[];
    readonly bolt: Bolt | undefined;
    readonly frame: SheetFrame | undefined;
  };
  /** Stops the search for a marker, so that all pieces stay in place. */
  hold(): void;
  choose(number: number | undefined): void;
  point(number: number | undefined): void;
  move(piece: PieceOnFabric, place: Alignment): void;
  addFlaw(flaw: readonly Point[]): void;
  requestUpdate(): void;
}

interface Press {
  readonly pointer: number;
  readonly piece: PieceOnFabric;
  /** Start of the press: `screen` in CSS px, `from` on the fabric in cm. */
  readonly screen: Point;
  readonly from: Point;
  readonly frame: SheetFrame | undefined;
}

export class MarkerPointing {
  readonly #fabric: PointedFabric;
  #press: Press | undefined;
  #drag: PieceDrag | undefined;
  #flawTool: FlawTool | undefined;
  /** Last position of the pointer, to be drawn with the next frame. */
  #last: {readonly at: Point; readonly takes: boolean} | undefined;
  #drawing: number | undefined;

  constructor(fabric: PointedFabric) {
    this.#fabric = fabric;
  }

  get isMarking(): boolean {
    return this.#flawTool !== undefined;
  }

  get dragged(): Dragged | undefined {
    return this.#drag?.shown;
  }

  get draft(): readonly Point[] {
    return this.#flawTool?.draft ?? [];
  }

  /** The frame stays the same during a drag. */
  get frame(): SheetFrame | undefined {
    return this.#drag && this.#press?.frame;
  }

  toggleFlawTool(): void {
    this.#flawTool = this.#flawTool ? undefined : new FlawTool();
    this.#fabric.requestUpdate();
  }

  readonly press = (event: PointerEvent): void => {
    const {isReady, shown} = this.#fabric;
    const at = pointOf(event);
    if (!isReady || event.button !== 0 || !at) return;
    const stage = event.currentTarget as HTMLElement;
    if (this.#flawTool) {
      event.preventDefault();
      stage.setPointerCapture(event.pointerId);
      this.#flawTool.press(at);
      this.#fabric.requestUpdate();
      return;
    }
    const number = numberOf(event);
    const piece = shown.pieces.find((one) => one.number === number);
    this.#fabric.choose(piece?.number);
    if (!piece) return;
    stage.setPointerCapture(event.pointerId);
    this.#press = {
      ...{pointer: event.pointerId, piece, from: at, frame: shown.frame},
      screen: [event.clientX, event.clientY],
    };
  };

  readonly move = (event: PointerEvent): void => {
    const at = pointOf(event);
    if (!at) return;
    if (this.#flawTool) {
      this.#flawTool.move(at);
      this.#fabric.requestUpdate();
      return;
    }
    const press = this.#press;
    if (!press) {
      this.#fabric.point(numberOf(event));
      return;
    }
    if (press.pointer !== event.pointerId) return;
    const [x, y] = minus([event.clientX, event.clientY], press.screen);
    if (!this.#drag && Math.hypot(x, y) < leastWay) return;
    this.#last = {at, takes: event.altKey};
    this.#begin(press);
  };

  #begin({piece}: Press): void {
    const {pieces, bolt} = this.#fabric.shown;
    if (!bolt) return;
    if (!this.#drag) {
      this.#fabric.hold();
      this.#drag = new PieceDrag(pieces, piece, bolt);
    }
    this.#drawing ??= requestAnimationFrame(this.#draw);
  }

  readonly #draw = (): void => {
    this.#drawing = undefined;
    const [drag, press, last] = [this.#drag, this.#press, this.#last];
    if (!drag || !press) return;
    if (last) drag.moveBy(minus(last.at, press.from), last.takes);
    this.#last = undefined;
    if (drag.look(lookTime)) this.#drawing = requestAnimationFrame(this.#draw);
    this.#fabric.requestUpdate();
  };

  readonly release = (event: PointerEvent): void => {
    const at = pointOf(event);
    if (this.#flawTool && at) {
      const flaw = this.#flawTool.release(at);
      if (flaw) this.#add(flaw);
      this.#fabric.requestUpdate();
      return;
    }
    const [drag, press] = [this.#drag, this.#press];
    this.#end();
    if (!drag || !press || !at) return;
    drag.moveBy(minus(at, press.from), event.altKey);
    if (Math.hypot(...drag.way) > 1e-6) this.#fabric.move(drag.piece, drag.place);
  };

  readonly closeFlaw = (): void => {
    const flaw = this.#flawTool?.close();
    if (flaw) this.#add(flaw);
  };

  readonly leave = (): void => {
    this.#fabric.point(undefined);
  };

  /** Ends a drag or the drawing of a flaw. @returns true if either was active */
  readonly cancel = (): boolean => {
    const isActive = this.#drag !== undefined || this.#flawTool !== undefined;
    this.#flawTool = undefined;
    this.#end();
    return isActive;
  };

  #add(flaw: readonly Point[]): void {
    this.#flawTool = undefined;
    this.#fabric.addFlaw(flaw);
  }

  #end(): void {
    if (this.#drawing !== undefined) cancelAnimationFrame(this.#drawing);
    [this.#drag, this.#press, this.#last, this.#drawing] = [
      undefined,
      undefined,
      undefined,
      undefined,
    ];
    this.#fabric.requestUpdate();
  }
}

const sheetOf = ({currentTarget}: Event): SVGSVGElement | null =>
  (currentTarget as Element).querySelector<SVGSVGElement>('.sheet');

/** Returns the position of the pointer on the fabric. [cm] */
function pointOf(event: PointerEvent): Point | undefined {
  const matrix = sheetOf(event)?.getScreenCTM();
  if (!matrix) return undefined;
  return offSheet(new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix.inverse()));
}

/** Returns the number of the piece under the pointer. */
function numberOf({target}: PointerEvent): number | undefined {
  const piece = target instanceof Element ? target.closest<SVGElement>('.piece') : null;
  return piece ? Number(piece.dataset.number) : undefined;
}
