/** Follows the operators of a page and collects its visible lines and words. */
import type {Box} from '../../../model/geometry/polyline.js';
import {boxOf} from '../../../model/geometry/polyline.js';
import {
  after,
  apply,
  identity,
  shifting,
  type PlaneMap,
} from '../../../model/geometry/plane-map.js';
import type {Point} from '../../../model/geometry/vectors.js';
import {common, partsInBox} from './cut-lines.js';
import {growthOf, initialGraphics, mapOf, transformed, type Graphics} from './graphics.js';
import type {InkLine, InkStyle, InkText, PageInk} from './ink.js';
import {isHelpLayer} from './layer-words.js';
import {linesOfPath} from './page-paths.js';
import type {OperatorList} from './operator-port.js';
import {joinedText, shownText} from './page-texts.js';
import type {ReadingBudget} from './reading-budget.js';

/** Operators by name, as pdf.js numbers them. */
type Operators = Readonly<Record<string, number>>;

export interface PageFrame {
  readonly number: number;
  readonly width: number;
  readonly height: number;
  /** From the page's units to mm. */
  readonly map: PlaneMap;
}

/** Greatest side of a filled area without a stroke that is kept, as a mark. [mm] */
const largestFill = 15;
/** Greatest number of such marks on a page; more are a picture. */
const mostFills = 3000;

/** Lines of this lightness and above are invisible on paper. */
const white = 0.95;

/** Collects the ink of a page from its operators. */
interface PageReader {
  /** @throws {RangeError} if the budget is exceeded */
  readonly read: (list: OperatorList) => void;
  readonly result: () => PageInk;
}

/**
 * Returns the reader of a page.
 * @param layerNames names of layers by the identifiers of pdf.js
 */
export function inkReader(
  operators: Operators,
  frame: PageFrame,
  layerNames: ReadonlyMap<string, string>,
  budget: ReadingBudget,
): PageReader {
  const reader = new InkReader(frame, layerNames, budget);
  const actions = actionsOf(reader, operators);
  return {
    read: ({fnArray, argsArray}) => {
      budget.spend('operators', fnArray.length);
      for (let k = 0; k < fnArray.length; k++) {
        const args = argsArray[k];
        actions.get(fnArray[k] ?? -1)?.(Array.isArray(args) ? (args as unknown[]) : []);
      }
    },
    result: () => reader.result(),
  };
}

const numbers = (value: unknown): ArrayLike<number> =>
  Array.isArray(value) || ArrayBuffer.isView(value) ? (value as unknown as number[]) : [];

const numberAt = (args: readonly unknown[], k: number): number =>
  typeof args[k] === 'number' ? args[k] : 0;

type Action = (args: readonly unknown[]) => void;

function actionsOf(reader: InkReader, operators: Operators): ReadonlyMap<number, Action> {
  const text = (change: (args: readonly unknown[]) => Partial<Graphics['text']>): Action => {
    return (args) => {
      reader.set({text: {...reader.state.text, ...change(args)}});
    };
  };
  const line = ([x, y]: Point): Partial<Graphics['text']> => {
    const matrix = after(reader.state.text.lineMatrix, shifting(x, y));
    return {matrix, lineMatrix: matrix};
  };
  const nextLine = (): Partial<Graphics['text']> => line([0, -reader.state.text.leading]);
  const byName: Readonly<Record<string, Action>> = {
    save: () => {
      reader.save();
    },
    restore: () => {
      reader.restore();
    },
    transform: (args) => {
      reader.transform(mapOf(args as number[]));
    },
    setLineWidth: (args) => {
      reader.set({width: numberAt(args, 0)});
    },
    setDash: ([dash]) => {
      reader.set({dash: Array.from(numbers(dash))});
    },
    setStrokeRGBColor: ([colour]) => {
      reader.set({stroke: String(colour)});
    },
    setFillRGBColor: ([colour]) => {
      reader.set({fill: String(colour)});
    },
    setGState: ([entries]) => {
      reader.setMore(entries);
    },
    clip: () => {
      reader.clipNext();
    },
    eoClip: () => {
      reader.clipNext();
    },
    constructPath: ([code, data, extent]) => {
      const does = (names: readonly string[]): boolean =>
        names.some((name) => operators[name] === code);
      const paint = {
        strokes: does(paints.strokes),
        fills: does(paints.fills),
        closes: does(paints.closes),
      };
      reader.path(paint, numbers((data as unknown[] | null)?.[0]), numbers(extent));
    },
    paintFormXObjectBegin: ([matrix, box]) => {
      reader.beginForm(numbers(matrix), numbers(box));
    },
    paintFormXObjectEnd: () => {
      reader.restore();
    },
    beginMarkedContent: () => {
      reader.beginLayer(undefined);
    },
    beginMarkedContentProps: ([tag, properties]) => {
      reader.beginLayer(tag === 'OC' ? properties : undefined);
    },
    endMarkedContent: () => {
      reader.endLayer();
    },
    beginText: text(() => ({matrix: identity, lineMatrix: identity})),
    setFont: text((args) => ({size: numberAt(args, 1)})),
    setCharSpacing: text((args) => ({letterSpace: numberAt(args, 0)})),
    setWordSpacing: text((args) => ({wordSpace: numberAt(args, 0)})),
    setHScale: text((args) => ({scale: numberAt(args, 0) / 100})),
    setLeading: text((args) => ({leading: -numberAt(args, 0)})),
    setLeadingMoveText: text((args) => ({
      leading: -numberAt(args, 1),
      ...line([numberAt(args, 0), numberAt(args, 1)]),
    })),
    setTextRise: text((args) => ({rise: numberAt(args, 0)})),
    moveText: text((args) => line([numberAt(args, 0), numberAt(args, 1)])),
    setTextMatrix: text(([matrix]) => {
      const map = mapOf(numbers(matrix));
      return {matrix: map, lineMatrix: map};
    }),
    nextLine: text(nextLine),
    showText: ([glyphs]) => {
      reader.show(glyphs);
    },
    nextLineShowText: (args) => {
      reader.set({text: {...reader.state.text, ...nextLine()}});
      reader.show(args.at(-1));
    },
  };
  return new Map(
    Object.entries(byName).flatMap(([name, act]): [number, Action][] => {
      const code = operators[name];
      return code === undefined ? [] : [[code, act]];
    }),
  );
}

/** Effects of the operators that paint a path. */
const paints = {
  strokes: [
    'stroke',
    'closeStroke',
    'fillStroke',
    'eoFillStroke',
    'closeFillStroke',
    'closeEOFillStroke',
  ],
  fills: ['fill', 'eoFill', 'fillStroke', 'eoFillStroke', 'closeFillStroke', 'closeEOFillStroke'],
  closes: ['closeStroke', 'closeFillStroke', 'closeEOFillStroke'],
};

interface Paint {
  readonly strokes: boolean;
  readonly fills: boolean;
  readonly closes: boolean;
}

class InkReader {
  state: Graphics;
  readonly #frame: PageFrame;
  readonly #layerNames: ReadonlyMap<string, string>;
  readonly #budget: ReadingBudget;
  readonly #saved: Graphics[] = [];
  /** The innermost named layer at each depth. */
  readonly #layers: (string | undefined)[] = [];
  readonly #lines: InkLine[] = [];
  readonly #fills: InkLine[] = [];
  readonly #texts: InkText[] = [];
  readonly #styles = new Map<string, InkStyle>();
  /** The style of the last line, as most lines have that of the line before. */
  #last:
    | {
        readonly state: Graphics;
        readonly isFilled: boolean;
        readonly hasStroke: boolean;
        readonly style: InkStyle;
      }
    | undefined;
  readonly #windows = new Map<string, {readonly box: Box; uses: number}>();
  #clips = false;
  #markPoints = 0;
  #hasMoreMarks = false;

  constructor(frame: PageFrame, layerNames: ReadonlyMap<string, string>, budget: ReadingBudget) {
    this.#frame = frame;
    this.#layerNames = layerNames;
    this.#budget = budget;
    this.state = initialGraphics(frame.map, this.#whole);
  }

  get #whole(): Box {
    return {low: [0, 0], high: [this.#frame.width, this.#frame.height]};
  }

  get #layer(): string | undefined {
    return this.#layers.at(-1);
  }

  result(): PageInk {
    const {number, width, height} = this.#frame;
    const [most] = [...this.#windows.values()].sort((a, b) => b.uses - a.uses);
    const isPicture = this.#fills.length > mostFills;
    if (isPicture) this.#budget.take('points of marks', -this.#markPoints);
    const fills = isPicture ? [] : this.#fills;
    return {
      ...(this.#hasMoreMarks && !isPicture && {hasMoreMarks: true}),
      ...{number, width, height},
      window: most?.box ?? this.#whole,
      lines: [...this.#lines, ...fills],
      texts: this.#texts.map((one) => ({...one, text: one.text.trim()})),
    };
  }

  set(change: Partial<Graphics>): void {
    this.state = {...this.state, ...change};
  }

  setMore(entries: unknown): void {
    if (!Array.isArray(entries)) return;
    for (const entry of entries as unknown[]) {
      const [key, value] = Array.isArray(entry) ? (entry as unknown[]) : [];
      if (key === 'LW') this.set({width: Number(value)});
      if (key === 'CA') this.set({strokeOpacity: Number(value)});
      if (key === 'ca') this.set({fillOpacity: Number(value)});
      if (key === 'D') this.set({dash: Array.from(numbers((value as unknown[])[0]))});
      if (key === 'Font') {
        this.set({text: {...this.state.text, size: numberAt(value as unknown[], 1)}});
      }
    }
  }

  save(): void {
    this.#budget.spend('nested groups', 1);
    this.#saved.push(this.state);
  }

  restore(): void {
    const state = this.#saved.pop();
    if (!state) return;
    this.#budget.take('nested groups', -1);
    this.state = state;
  }

  transform(map: PlaneMap): void {
    this.state = transformed(this.state, map);
  }

  beginForm(matrix: ArrayLike<number>, box: ArrayLike<number>): void {
    this.save();
    if (matrix.length === 6) this.transform(mapOf(matrix));
    if (box.length === 4) this.#clipTo(box);
  }

  beginLayer(properties: unknown): void {
    this.#budget.spend('nested groups', 1);
    const {id, ids} = (properties ?? {}) as {readonly id?: unknown; readonly ids?: unknown};
    const [first] = Array.isArray(ids) ? (ids as unknown[]) : [id];
    this.#layers.push(this.#layerNames.get(String(first)) ?? this.#layer);
  }

  endLayer(): void {
    if (this.#layers.length === 0) return;
    this.#budget.take('nested groups', -1);
    this.#layers.pop();
  }

  clipNext(): void {
    this.#clips = true;
  }

  path(paint: Paint, data: ArrayLike<number>, extent: ArrayLike<number>): void {
    const {state} = this;
    const isStroked = paint.strokes && this.#isVisible(state.stroke, state.strokeOpacity);
    const isFilled = paint.fills && this.#isVisible(state.fill, state.fillOpacity);
    if (isStroked) this.#add(data, this.#styleOf(isFilled, true), paint.closes);
    else if (isFilled && this.#isSmall(extent) && this.#fills.length <= mostFills) {
      this.#add(data, this.#styleOf(true, false), true);
    }
    if (this.#clips && extent.length === 4) this.#clipTo(extent);
    this.#clips = false;
  }

  show(glyphs: unknown): void {
    if (!Array.isArray(glyphs)) return;
    const {ink, text} = shownText(
      this.state,
      glyphs as Parameters<typeof shownText>[1],
      this.#layer,
    );
    this.set({text});
    if (!ink) return;
    const {low, high} = this.state.clip;
    const [x, y] = [(ink.from[0] + ink.to[0]) / 2, (ink.from[1] + ink.to[1]) / 2];
    if (x < low[0] || x > high[0] || y < low[1] || y > high[1]) return;
    const longer = joinedText(this.#texts.at(-1), ink);
    if (longer) {
      this.#texts[this.#texts.length - 1] = longer;
      return;
    }
    this.#budget.spend('texts', 1);
    this.#texts.push(ink);
  }

  #isVisible(colour: string, opacity: number): boolean {
    const levels = [1, 3, 5].map((k) => parseInt(colour.slice(k, k + 2), 16) / 255);
    return opacity > 0.05 && !levels.every((level) => level >= white);
  }

  #isSmall(extent: ArrayLike<number>): boolean {
    const {low, high} = boxIn(extent, this.state.map);
    return Math.max(high[0] - low[0], high[1] - low[1]) <= largestFill;
  }

  #clipTo(extent: ArrayLike<number>): void {
    const clip = common(this.state.clip, boxIn(extent, this.state.map));
    this.set({clip});
  }

  #styleOf(isFilled: boolean, hasStroke: boolean): InkStyle {
    const last = this.#last;
    const layer = this.#layer;
    const isSame =
      last?.state === this.state &&
      last.isFilled === isFilled &&
      last.hasStroke === hasStroke &&
      last.style.layer === layer;
    if (isSame) return last.style;
    const style = this.#newStyle(isFilled, hasStroke, layer);
    this.#last = {state: this.state, isFilled, hasStroke, style};
    return style;
  }

  #newStyle(isFilled: boolean, hasStroke: boolean, layer: string | undefined): InkStyle {
    const {stroke, fillOpacity, strokeOpacity, width, dash, map} = this.state;
    const growth = growthOf(map);
    const round = (length: number): number => Number((length * growth).toFixed(2));
    const style: InkStyle = {
      ...(hasStroke && {stroke}),
      ...{isFilled, widthMm: round(width)},
      dashMm: dash.some((part) => part > 0) ? dash.map(round) : [],
      opacity: hasStroke ? strokeOpacity : fillOpacity,
      ...(layer !== undefined && {layer}),
    };
    const key = JSON.stringify(style);
    const known = this.#styles.get(key) ?? style;
    this.#styles.set(key, known);
    return known;
  }

  #add(data: ArrayLike<number>, style: InkStyle, closes: boolean): void {
    const {clip, map} = this.state;
    if (style.layer !== undefined && isHelpLayer(style.layer)) return;
    this.#budget.spend('points', data.length / 3);
    for (const line of linesOfPath(data, map)) {
      const whole = closes ? {...line, isClosed: true} : line;
      for (const {points, isClosed} of partsInBox(whole, clip)) {
        if (style.stroke === undefined) this.#addMark({points, isClosed, style});
        else {
          this.#budget.spend('visible lines', 1);
          this.#budget.spend('visible points', points.length);
          this.#lines.push({points, isClosed, style});
        }
      }
    }
    if (style.stroke !== undefined) this.#use(clip);
  }

  #addMark(mark: InkLine): void {
    const {length} = mark.points;
    if (!this.#budget.take('points of marks', length)) {
      this.#hasMoreMarks = true;
      return;
    }
    this.#markPoints += length;
    this.#fills.push(mark);
  }

  /** Counts the uses of a clip box. */
  #use(box: Box): void {
    const key = [...box.low, ...box.high].map((side) => side.toFixed(1)).join(' ');
    const known = this.#windows.get(key);
    if (known) known.uses++;
    else this.#windows.set(key, {box, uses: 1});
  }
}

/** The box around a mapped box, given by two corners. */
function boxIn(extent: ArrayLike<number>, map: PlaneMap): Box {
  const [x0 = 0, y0 = 0, x1 = 0, y1 = 0] = Array.from(extent);
  const corners: Point[] = [
    [x0, y0],
    [x1, y0],
    [x1, y1],
    [x0, y1],
  ];
  return boxOf(corners.map((corner) => apply(map, corner)));
}
