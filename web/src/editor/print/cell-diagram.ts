/** Diagram of a print's cell on the fabric, with its two measured sides. */
import {css, svg, html, type TemplateResult} from 'lit';

import {combined, norm, type Point} from '../../model/geometry/vectors.js';
import {latticeVectors, type RepeatSize} from '../../model/print/repeat.js';

interface CellDiagram {
  readonly size: RepeatSize;
  /** Counter-clockwise. [degrees] */
  readonly turnDeg: number;
  readonly names: {readonly width: string; readonly height: string};
  readonly label: string;
}

/** Size of the drawing. [px] */
const [wide, tall] = [260, 104];
/** Longest side of the box around the cell, and distance of names from it. [px] */
const room = 62;
const away = 9;

export function cellDiagram({size, turnDeg, names, label}: CellDiagram): TemplateResult {
  // any two sides at any angle form an oblique cell
  const [a, b] = latticeVectors('p1', size, turnDeg);
  const reach = (k: 0 | 1): number => Math.abs(a[k]) + Math.abs(b[k]);
  const scale = Math.min((1.8 * room) / reach(0), room / reach(1));
  const at = (s: number, t: number): Point => {
    const [x, y] = combined([a, b], s - 1 / 2, t - 1 / 2);
    return [wide / 2 + scale * x, tall / 2 - scale * y];
  };
  const line = (...points: readonly Point[]): string =>
    `M${points.map((p) => p.join(' ')).join('L')}`;
  const named = (name: string, [x, y]: Point): TemplateResult => {
    const [outX, outY] = [x - wide / 2, y - tall / 2];
    const length = norm([outX, outY]) || 1;
    const anchor = Math.abs(outX) < 0.5 * length ? 'middle' : outX > 0 ? 'start' : 'end';
    return svg`<text
      x=${x + (away * outX) / length}
      y=${y + (away * outY) / length + 4}
      text-anchor=${anchor}
    >${name}</text>`;
  };
  return html`<svg class="cell" viewBox="0 0 ${wide} ${tall}" role="img" aria-label=${label}>
    ${svg`<path class="inside" d="${line(at(0, 0), at(1, 0), at(1, 1), at(0, 1))}z"></path>
      <path class="side" d=${line(at(0, 0), at(1, 0))}></path>
      <path class="side up" d=${line(at(0, 0), at(0, 1))}></path>
      ${named(names.width, at(0.5, 0))} ${named(names.height, at(0, 0.5))}
      <path class="warp" d="M${wide - 12} 88V18m-4 6 4-7 4 7"></path>`}
  </svg>`;
}

export const cellDiagramStyle = css`
  .cell {
    width: 100%;
    max-width: 18rem;
  }
  .cell path {
    fill: none;
    stroke-linecap: round;
    stroke-linejoin: round;
  }
  .cell .inside {
    fill: var(--sw-tint);
    stroke: var(--sw-line);
  }
  .cell .side {
    stroke: var(--sw-accent);
    stroke-width: 3;
  }
  .cell .up {
    stroke-dasharray: 1 5;
  }
  .cell .warp {
    stroke: var(--sw-soft);
    stroke-width: 1.2;
  }
  .cell text {
    font-size: 12px;
    fill: var(--sw-ink);
  }
`;
