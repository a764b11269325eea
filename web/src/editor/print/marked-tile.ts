/** The image of a print with its mismatches marked. */
import {css, html, svg, type TemplateResult} from 'lit';

import type {TileBreak} from '../../image/tile-check.js';
import type {OpenEdge} from '../../model/print/photo-reading.js';

/** Returns the outline of adjacent places: the sides that belong to one place only. */
export function outlineOf(breaks: readonly TileBreak[]): string {
  const sides = new Map<string, number>();
  for (const {x, y, width, height} of breaks) {
    const [left, right] = [x, x + width].map((value) => value.toFixed(4));
    const [top, bottom] = [y, y + height].map((value) => value.toFixed(4));
    for (const side of [
      `M${left} ${top}H${right}`,
      `M${left} ${bottom}H${right}`,
      `M${left} ${top}V${bottom}`,
      `M${right} ${top}V${bottom}`,
    ]) {
      sides.set(side, (sides.get(side) ?? 0) + 1);
    }
  }
  return Array.from(sides)
    .filter(([, times]) => times === 1)
    .map(([side]) => side)
    .join('');
}

export function edgesPath(edges: readonly OpenEdge[]): string {
  return edges
    .map(({side, from, to}) => {
      switch (side) {
        case 'left':
          return `M0 ${from}V${to}`;
        case 'right':
          return `M1 ${from}V${to}`;
        case 'top':
          return `M${from} 0H${to}`;
        case 'bottom':
          return `M${from} 1H${to}`;
      }
    })
    .join('');
}

interface MarkedPicture {
  readonly image: string;
  /** Size of the image. */
  readonly size: {readonly width: number; readonly height: number};
  /** Rotation that makes the image upright, counter-clockwise. [degrees] */
  readonly turnDeg: 0 | 90;
  /** A path in shares of the image, from its upper left corner. */
  readonly marks: string;
  readonly label: string;
}

/** Margin around the image for lines on its edges, as a share of its longer side. */
const margin = 0.04;

export function markedTile({image, size, turnDeg, marks, label}: MarkedPicture): TemplateResult {
  const scale = 1 / Math.max(size.width, size.height);
  const [width, height] = [size.width * scale, size.height * scale];
  const [across, up] = turnDeg === 0 ? [width, height] : [height, width];
  const upright = turnDeg === 0 ? '' : `translate(0 ${up}) rotate(-90)`;
  return html`<svg
    viewBox="${-margin} ${-margin} ${across + 2 * margin} ${up + 2 * margin}"
    role="img"
    aria-label=${label}
  >
    ${svg`<g transform=${upright}>
      <image href=${image} width=${width} height=${height} preserveAspectRatio="none"></image>
      <g transform="scale(${width} ${height})">
        <path class="casing" d=${marks}></path>
        <path class="line" d=${marks}></path>
      </g>
    </g>`}
  </svg>`;
}

/** Styles of a box with such an image and its text. */
export const markedTileStyle = css`
  .breaks {
    display: grid;
    grid-template-columns: 7rem 1fr;
    gap: var(--sw-space-3);
    padding: var(--sw-space-3);
    border-radius: var(--sw-radius);
    background: var(--sw-bad-tint);
  }
  .breaks > div {
    display: grid;
    align-content: start;
    gap: var(--sw-space-2);
  }
  .row {
    display: flex;
    flex-wrap: wrap;
    gap: var(--sw-space-2);
  }
  .row button {
    white-space: normal;
    text-align: start;
  }
  .breaks svg {
    width: 100%;
    max-height: 10rem;
  }
  .breaks path {
    fill: none;
    stroke-linecap: square;
    vector-effect: non-scaling-stroke;
  }
  .casing {
    stroke: #fff;
    stroke-width: 6;
  }
  .line {
    stroke: #c22318;
    stroke-width: 3;
  }
`;
