/** Preview of the layout of pages and pieces, before a file is made. */
import {html, nothing, svg, type TemplateResult} from 'lit';

import type {Point} from '../../model/geometry/vectors.js';
import type {CutPlan} from './cut-job.js';

const short = (value: number): string => String(Number(value.toFixed(1)));
const line = (points: readonly Point[]): string =>
  `M${points.map(([x, y]) => `${short(x)} ${short(-y)}`).join('L')}Z`;

/** Margin around all pages. [share of the longer side] */
const rim = 0.01;

export function pageMap({widthCm, heightCm, outlines, pages}: CutPlan, label: string) {
  const boxes = pages?.boxes ?? [{low: [0, 0] as const, high: [widthCm, heightCm] as const}];
  const left = Math.min(...boxes.map(({low}) => low[0]));
  const right = Math.max(...boxes.map(({high}) => high[0]));
  const low = Math.min(...boxes.map((box) => box.low[1]));
  const high = Math.max(...boxes.map((box) => box.high[1]));
  const margin = rim * Math.max(right - left, high - low);
  const view = [left - margin, -high - margin, right - left + 2 * margin, high - low + 2 * margin];
  return html`<svg class="map" viewBox=${view.map(short).join(' ')} role="img" aria-label=${label}>
    ${boxes.map(
      (box) =>
        svg`<rect class="page" x=${short(box.low[0])} y=${short(-box.high[1])}
          width=${short(box.high[0] - box.low[0])} height=${short(box.high[1] - box.low[1])}></rect>`,
    )}
    <path class="pieces" d=${outlines.map(line).join('')}></path>
    ${boxes.length < 2 ? nothing : (pages?.boxes ?? []).map(nameOn)}
  </svg>`;
}

/** Page name in the upper left corner, at the same place as on paper. */
function nameOn({name, low, high}: NonNullable<CutPlan['pages']>['boxes'][number]): TemplateResult {
  const size = 0.22 * Math.min(high[0] - low[0], high[1] - low[1]);
  return svg`<text x=${short(low[0] + size / 2)} y=${short(-high[1] + 1.2 * size)}
    font-size=${short(size)}>${name}</text>`;
}
