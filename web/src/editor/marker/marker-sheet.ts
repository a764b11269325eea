/** Drawing of the fabric in its print, with edges, rulers and the pieces on it. */
import {css, html, nothing, svg, type TemplateResult} from 'lit';

import type {Dragged} from '../../workbench/marker/piece-drag.js';
import {nameLines, textWidth} from '../../layout/name-lines.js';
import {isFree, turnedRing, type Bolt} from '../../marker/places.js';
import {imageCell} from '../../model/print/wallpaper.js';
import {norm, onPiece, plus, type Point} from '../../model/geometry/vectors.js';
import type {Units} from '../../model/base/length-text.js';
import type {MarkerTexts} from '../../texts/marker-texts.js';
import type {PieceOnFabric} from '../../workbench/marker/marker-work.js';
import {colourClass, garmentColours} from './garment-colours.js';
import {
  closed,
  frameSize,
  onSheet,
  pixels,
  rulerMarks,
  unit,
  viewBox,
  type SheetFrame,
} from '../../marker/sheet-frame.js';

/** Styles of the fabric and of the pieces on it. */
export const sheetStyle = css`
  ${garmentColours}
  .sheet {
    display: block;
    user-select: none;
  }
  .stale .sheet {
    filter: grayscale(1);
    opacity: 0.45;
  }
  .sheet path,
  .sheet .selvedge {
    vector-effect: non-scaling-stroke;
  }
  .pale {
    fill: var(--sw-paper);
    opacity: 0.66;
  }
  .hatch {
    stroke: var(--sw-soft);
    stroke-width: 1.25;
  }
  .selvedge {
    fill: url(#hatching);
    stroke: none;
  }
  .edge {
    stroke: var(--sw-strong-line);
    stroke-width: 1;
  }
  .cut-edge {
    stroke: var(--sw-ink);
    stroke-width: 1.5;
    stroke-dasharray: 6 4;
  }
  .used {
    stroke: var(--sw-accent);
    stroke-width: 1.5;
  }
  .ruler path {
    stroke: var(--sw-strong-line);
    stroke-width: 1;
  }
  .ruler text {
    fill: var(--sw-soft);
    font-variant-numeric: tabular-nums;
  }
  .ruler .length {
    fill: var(--sw-accent);
    stroke: var(--sw-paper);
    stroke-linejoin: round;
    paint-order: stroke;
    font-weight: 600;
  }
  .piece {
    cursor: grab;
    touch-action: none;
  }
  .stale .piece {
    cursor: default;
  }
  .marking .sheet {
    cursor: crosshair;
    touch-action: none;
  }
  .marking .piece {
    cursor: inherit;
  }
  .piece .line {
    fill: none;
    stroke: #26282c;
    stroke-width: 1.25;
    stroke-linejoin: round;
  }
  .piece .veil {
    display: none;
  }
  .several .piece .veil {
    display: inline;
    fill: var(--garment);
    opacity: 0.16;
  }
  .several .piece .line {
    stroke: var(--garment);
    stroke-width: 2;
  }
  .piece.pointed .line {
    stroke-width: 2;
  }
  .piece.selected .line {
    stroke: #24507a;
    stroke-width: 3;
  }
  .several .piece.selected .line {
    stroke: var(--garment);
    stroke-width: 4;
  }
  .piece.bad .line,
  .several .piece.bad .line {
    fill: rgb(169 42 34 / 0.28);
    stroke: #a92a22;
    stroke-width: 2.5;
  }
  .piece.dragged {
    cursor: grabbing;
    filter: drop-shadow(0 3px 6px rgb(0 0 0 / 0.35));
  }
  .name {
    fill: #26282c;
    stroke: #fdfcfb;
    stroke-linejoin: round;
    paint-order: stroke;
    font-weight: 600;
    pointer-events: none;
  }
  .pin {
    pointer-events: none;
  }
  .pin circle {
    fill: #fdfcfb;
    stroke: #26282c;
    stroke-width: 1;
  }
  .pin path {
    fill: none;
    stroke: #26282c;
    stroke-width: 1.5;
    stroke-linecap: round;
    stroke-linejoin: round;
  }
  .dots {
    fill: none;
    stroke: #24507a;
    stroke-linecap: round;
    pointer-events: none;
  }
  /* in the units of the sheet */
  .sheet path.dots {
    vector-effect: none;
  }
  .dots.halo {
    stroke: #ffffff;
  }
  .target {
    fill: rgb(36 80 122 / 0.12);
    stroke: #24507a;
    stroke-width: 2;
    stroke-dasharray: 5 4;
    pointer-events: none;
  }
  .target.bad {
    fill: rgb(169 42 34 / 0.2);
    stroke: #a92a22;
  }
  .flaw {
    fill: rgb(169 42 34 / 0.35);
    stroke: #a92a22;
    stroke-width: 1.5;
    pointer-events: none;
  }
  .flaw.chosen {
    stroke-width: 3.5;
  }
  .flaw.draft {
    stroke-dasharray: 4 3;
  }
`;

interface SheetState {
  readonly frame: SheetFrame;
  readonly bolt: Bolt;
  readonly image: string;
  /** Used length of the fabric. [cm] */
  readonly usedCm: number;
  readonly usedWords: string;
  readonly pieces: readonly PieceOnFabric[];
  /** True if the pieces are of several garments, which have different colours. */
  readonly isOfSeveral: boolean;
  readonly label: (piece: PieceOnFabric) => string;
  readonly pins: ReadonlySet<number>;
  readonly selected: number | undefined;
  readonly pointed: number | undefined;
  /** Numbers of the pieces with a conflict. */
  readonly bad: ReadonlySet<number>;
  readonly dragged: Dragged | undefined;
  /** Index of the selected flaw. */
  readonly chosenFlaw: number | undefined;
  /** Outline of the flaw that is being drawn. */
  readonly draft: readonly Point[];
  readonly units: Units;
  readonly words: MarkerTexts;
}

/** There is no room for a label of the print's start beyond this share of the width. */
const latestStart = 0.6;

/** The cell of the print as a pattern fill, with its origin on the fabric. */
function printPattern({bolt: {repeat, origin}, image}: SheetState): TemplateResult {
  const [a, b] = imageCell(repeat);
  const [w, h] = [norm(a) * unit, norm(b) * unit];
  const [x, y] = onSheet(origin);
  // y points down in the image, against the second side of its cell
  const matrix = [a[0] / norm(a), -a[1] / norm(a), -b[0] / norm(b), b[1] / norm(b), x, y];
  return svg`<pattern id="print" patternUnits="userSpaceOnUse" width=${w} height=${h}
    patternTransform="matrix(${matrix.map((one) => one.toFixed(7)).join(' ')})">
    <rect width=${w} height=${h} fill="#f1ede3" />
    <image href=${image} width=${w} height=${h} preserveAspectRatio="none" />
  </pattern>`;
}

function hatching(frame: SheetFrame): TemplateResult {
  const side = pixels(frame, 6);
  return svg`<pattern id="hatching" patternUnits="userSpaceOnUse" width=${side} height=${side}
    patternTransform="rotate(45)"><path class="hatch" d="M0 0V${side}" /></pattern>`;
}

function edges({frame, bolt, usedCm, words}: SheetState): TemplateResult {
  const {widthCm, selvedgeCm} = bolt;
  const [right, top] = onSheet([widthCm, frame.lengthCm]);
  const side = selvedgeCm * unit;
  const strip = (x: number) =>
    svg`<rect class="selvedge" x=${x} y=${top} width=${side} height=${-top}><title>${words.selvedgeLabel}</title></rect>`;
  const [, used] = onSheet([0, usedCm]);
  return svg`
    ${selvedgeCm > 0 ? svg`${strip(0)}${strip(right - side)}` : nothing}
    <path class="edge" d="M0 0V${top}M${right} 0V${top}" />
    <path class="cut-edge" d="M0 0H${right}" />
    ${usedCm > 0 ? svg`<path class="used" d="M0 ${used}H${right}" />` : nothing}
  `;
}

function rulers(state: SheetState): TemplateResult {
  const {frame, bolt, usedCm, usedWords, units, words} = state;
  const {widthCm, origin} = bolt;
  const px = (count: number): number => pixels(frame, count);
  const size = px(11);
  const across = rulerMarks(widthCm, frame.scale, units).map(({at, label}) => {
    const x = at * unit;
    return svg`<path d="M${x} ${px(3)}v${px(label ? 7 : 4)}" />${
      label
        ? svg`<text x=${x} y=${px(21)} font-size=${size} text-anchor="middle">${label}</text>`
        : nothing
    }`;
  });
  const along = rulerMarks(frame.lengthCm, frame.scale, units).map(({at, label}) => {
    const y = -at * unit;
    return svg`<path d="M${px(-3)} ${y}h${px(label ? -7 : -4)}" />${
      label
        ? svg`<text x=${px(-13)} y=${y + px(4)} font-size=${size} text-anchor="end">${label}</text>`
        : nothing
    }`;
  });
  const start = origin[0] * unit;
  const isShown = start >= 0 && origin[0] <= widthCm * latestStart;
  return svg`<g class="ruler" aria-hidden="true">
    ${across} ${along}
    ${
      usedCm > 0
        ? svg`<text class="length" x=${widthCm * unit - px(6)} y=${-usedCm * unit - px(6)}
            font-size=${px(12)} stroke-width=${px(4)} text-anchor="end">${usedWords}</text>`
        : nothing
    }
    <text x=${widthCm * unit} y=${px(36)} font-size=${size} text-anchor="end">✂ ${words.cutEdge}</text>
    ${
      isShown
        ? svg`<text x=${start} y=${px(36)} font-size=${size} dx=${px(-4)}>↑ ${words.printStarts}</text>`
        : nothing
    }
  </g>`;
}

const outlines = new WeakMap<PieceOnFabric, string>();

/** The cut line at the place of the piece, cached. */
function outlineOf(piece: PieceOnFabric): string {
  const known =
    outlines.get(piece) ?? closed(piece.piece.outline.map((p) => onPiece(piece.place, p)));
  outlines.set(piece, known);
  return known;
}

/** A point well inside a piece. */
const middleOf = ({piece, place}: PieceOnFabric): Point =>
  plus(turnedRing(piece.outline, place.angle).inner, place.translation);

/** Font size of names. [CSS px] */
const nameSizes = {least: 8, most: 12} as const;
/** Distance of lines, as a multiple of the font size. */
const lineHeight = 1.15;

/** Splits a name into lines by the width of the piece, in the largest size that fits. */
function nameDrawing(piece: PieceOnFabric, label: string, frame: SheetFrame): TemplateResult {
  const {low, high} = turnedRing(piece.piece.outline, piece.place.angle);
  const room = (high[0] - low[0]) * frame.scale;
  const lines = nameLines(label, room, nameSizes.most);
  const widest = Math.max(...lines.map((line) => textWidth(line, 1)));
  const fitting = Math.min(nameSizes.most, Math.max(nameSizes.least, room / widest));
  const size = pixels(frame, fitting);
  const [x, y] = onSheet(middleOf(piece));
  const top = y + size * (0.35 - ((lines.length - 1) / 2) * lineHeight);
  return svg`<text class="name" font-size=${size} stroke-width=${pixels(frame, 4)}
    text-anchor="middle">${lines.map(
      (line, k) => svg`<tspan x=${x} y=${top + k * lineHeight * size}>${line}</tspan>`,
    )}</text>`;
}

/** Pin symbol. @param px units of the drawing per CSS pixel */
const pinDrawing = ([x, y]: Point, px: number): TemplateResult =>
  svg`<g class="pin" transform="translate(${x} ${y}) scale(${px})">
    <circle r="11" /><path d="M-2.5 -6h5M-1.5 -6v4.5L-4 1h8L1.5 -1.5V-6M0 1V6" />
  </g>`;

function pieceDrawing(piece: PieceOnFabric, state: SheetState): TemplateResult {
  const {frame, label, pins, selected, pointed, bad, dragged} = state;
  const {number} = piece;
  const isDragged = dragged?.piece.number === number;
  const [x, y] = onSheet(middleOf(piece));
  const [byX, byY] = onSheet(isDragged ? dragged.by : [0, 0]);
  const px = (count: number): number => pixels(frame, count);
  const classes = [
    'piece',
    colourClass(piece.garment),
    ...(selected === number ? ['selected'] : []),
    ...(pointed === number ? ['pointed'] : []),
    ...((isDragged ? !isFree(dragged.inWay) : bad.has(number)) ? ['bad'] : []),
    ...(isDragged ? ['dragged'] : []),
  ].join(' ');
  const d = outlineOf(piece);
  return svg`<g class=${classes} data-number=${number} transform="translate(${byX} ${byY})">
    <path class="cloth" d=${d} fill="url(#print)" />
    <path class="veil" d=${d} />
    <path class="line" d=${d} />
    ${pins.has(number) ? pinDrawing([x, y - px(26)], px(1)) : nothing}
    ${nameDrawing(piece, label(piece), frame)}
  </g>`;
}

/** Outline of the dragged piece at the place that it would take. */
const target = ({target: line, inWay}: Dragged): TemplateResult =>
  svg`<path class="target ${isFree(inWay) ? '' : 'bad'}" d=${closed(line)} />`;

/** Free places of the dragged piece. */
function dots({dots: all}: Dragged, frame: SheetFrame): TemplateResult {
  const d = all
    .filter(([, y]) => y < frame.lengthCm) // only the displayed fabric
    .map((dot) => {
      const [x, y] = onSheet(dot);
      return `M${x.toFixed(0)} ${y.toFixed(0)}h0`;
    })
    .join('');
  return svg`<path class="dots halo" d=${d} stroke-width=${pixels(frame, 8)} />
    <path class="dots" d=${d} stroke-width=${pixels(frame, 5)} />`;
}

export function markerSheet(state: SheetState): TemplateResult {
  const {frame, bolt, pieces, dragged, draft} = state;
  const [width, height] = frameSize(frame);
  const [right, top] = onSheet([bolt.widthCm, frame.lengthCm]);
  // the dragged piece is drawn on top, then the selected one
  const rank = ({number}: PieceOnFabric): number =>
    number === dragged?.piece.number ? 2 : number === state.selected ? 1 : 0;
  const ordered = [...pieces].sort((one, other) => rank(one) - rank(other));
  const below = dragged ? ordered.length - 1 : ordered.length;
  return html`<svg
    class=${state.isOfSeveral ? 'sheet several' : 'sheet'}
    width=${width}
    height=${height}
    viewBox=${viewBox(frame)}
    aria-hidden="true"
  >
    <defs>${printPattern(state)}${hatching(frame)}</defs>
    <rect y=${top} width=${right} height=${-top} fill="url(#print)" />
    <rect class="pale" y=${top} width=${right} height=${-top} />
    ${edges(state)} ${rulers(state)}
    ${bolt.flaws.map((flaw, k) => flawDrawing(flaw, k === state.chosenFlaw))}
    ${ordered.slice(0, below).map((piece) => pieceDrawing(piece, state))}
    ${dragged ? target(dragged) : nothing}
    ${ordered.slice(below).map((piece) => pieceDrawing(piece, state))}
    ${dragged ? dots(dragged, frame) : nothing}
    ${draft.length > 0 ? svg`<path class="flaw draft" d=${closed(draft)} />` : nothing}
  </svg>`;
}

const flawDrawing = (flaw: readonly Point[], isChosen: boolean): TemplateResult =>
  svg`<path class="flaw ${isChosen ? 'chosen' : ''}" d=${closed(flaw)} />`;
