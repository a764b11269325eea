/** Preview of the layout of pages and pieces, before a file is made. */
import {html, nothing, svg, type TemplateResult} from 'lit';

import {paleWhite, type PrintInk} from '../../cutting/print-ink.js';
import {norm, rotated, type Alignment, type Point} from '../../model/geometry/vectors.js';
import type {Box} from '../../model/geometry/polyline.js';
import type {CutPlan, PrintOnMap} from './cut-job.js';

const short = (value: number): string => String(Number(value.toFixed(1)));
const line = (points: readonly Point[]): string =>
  `M${points.map(([x, y]) => `${short(x)} ${short(-y)}`).join('L')}Z`;

/** Margin around all pages. [share of the longer side] */
const rim = 0.01;

/** @param ink  how the pieces show their print */
export function pageMap(plan: CutPlan, ink: PrintInk, label: string) {
  const {widthCm, heightCm, pieces, print, pages} = plan;
  const boxes = pages?.boxes ?? [{low: [0, 0] as const, high: [widthCm, heightCm] as const}];
  const left = Math.min(...boxes.map(({low}) => low[0]));
  const right = Math.max(...boxes.map(({high}) => high[0]));
  const low = Math.min(...boxes.map((box) => box.low[1]));
  const high = Math.max(...boxes.map((box) => box.high[1]));
  const margin = rim * Math.max(right - left, high - low);
  const view = [left - margin, -high - margin, right - left + 2 * margin, high - low + 2 * margin];
  return html`<svg class="map" viewBox=${view.map(short).join(' ')} role="img" aria-label=${label}>
    ${boxes.map((box) => rectangle(box, 'page'))}
    ${ink === 'outline' || !print ? nothing : pieces.map((piece, k) => inPrint(piece, k, print, ink))}
    <path
      class="pieces ${ink === 'outline' || print ? 'bare' : ''}"
      d=${pieces.map(pathOf).join('')}
    ></path>
    ${boxes.map((box) => rectangle(box, 'joint'))}
    ${boxes.length < 2 ? nothing : (pages?.boxes ?? []).map(nameOn)}
  </svg>`;
}

const rectangle = ({low, high}: Box, kind: 'page' | 'joint'): TemplateResult =>
  svg`<rect class=${kind} x=${short(low[0])} y=${short(-high[1])}
    width=${short(high[0] - low[0])} height=${short(high[1] - low[1])}></rect>`;

type MappedPiece = CutPlan['pieces'][number];

const pathOf = ({cut}: MappedPiece): string => cut.map(line).join('');

/** A piece, filled with its print. */
function inPrint(
  piece: MappedPiece,
  number: number,
  print: PrintOnMap,
  ink: PrintInk,
): TemplateResult | typeof nothing {
  const {alignment} = piece;
  if (!alignment) return nothing;
  const [wide, high] = print.cell.map(norm);
  const id = `print-${number}`;
  const path = pathOf(piece);
  return svg`<pattern id=${id} patternUnits="userSpaceOnUse" width=${wide} height=${high}
      patternTransform=${onMap(print, alignment)}>
      <image href=${print.picture} width=${wide} height=${high} preserveAspectRatio="none"></image>
    </pattern>
    <path class="print" d=${path} fill="url(#${id})"></path>
    ${ink === 'pale' ? svg`<path class="print" d=${path} fill="#fff" fill-opacity=${paleWhite}></path>` : nothing}`;
}

/** The map from the picture, whose y runs down, to the map of pages. */
function onMap({cell: [across, up]}: PrintOnMap, {angle, translation}: Alignment): string {
  const [a, b] = [across, up].map((side) => rotated(side, angle).map((v) => v / norm(side)));
  const [[ax = 0, ay = 0], [bx = 0, by = 0]] = [a ?? [], b ?? []];
  const matrix = [ax, -ay, -bx, by, translation[0], -translation[1]];
  return `matrix(${matrix.map((value) => value.toFixed(6)).join(' ')})`;
}

/** Page name in the upper left corner, at the same place as on paper. */
function nameOn({name, low, high}: NonNullable<CutPlan['pages']>['boxes'][number]): TemplateResult {
  const size = 0.22 * Math.min(high[0] - low[0], high[1] - low[1]);
  return svg`<text x=${short(low[0] + size / 2)} y=${short(-high[1] + 1.2 * size)}
    font-size=${short(size)}>${name}</text>`;
}
