/** Empty state of the fabric layout: a picture of pieces on fabric, and one sentence. */
import {css, html, svg, type TemplateResult} from 'lit';

export const emptyStyle = css`
  .empty {
    display: grid;
    justify-items: center;
    gap: var(--sw-space-4);
    max-width: 22rem;
    padding: var(--sw-space-4);
    color: var(--sw-soft);
    text-align: center;
  }
  .empty svg {
    width: min(14rem, 60%);
    fill: none;
    stroke: var(--sw-strong-line);
    stroke-width: 1.5;
    stroke-linejoin: round;
  }
  .empty .dots {
    fill: var(--sw-line);
    stroke: none;
  }
  .empty .cut {
    fill: var(--sw-raised);
    stroke: var(--sw-soft);
  }
`;

/** Dots of the pictured print, every 16 units. */
const dots = [0, 1, 2, 3, 4, 5, 6, 7].flatMap((i) =>
  [0, 1, 2, 3, 4].map(
    (j) => svg`<circle cx=${24 + 16 * i + (j % 2) * 8} cy=${14 + 16 * j} r="2" />`,
  ),
);

export const markerEmpty = (sentence: string): TemplateResult =>
  html`<div class="empty">
    <svg viewBox="0 0 160 96" aria-hidden="true">
      <path d="M8 4v88M152 4v88" />
      <path d="M8 92h144" stroke-dasharray="5 4" />
      <g class="dots">${dots}</g>
      <path class="cut" d="M20 84V40c6-2 9-6 10-12h24c1 6 4 10 10 12v44z" />
      <path class="cut" d="M76 84V46c6-2 9-8 10-14h22c1 6 4 12 10 14v38z" />
      <path class="cut" d="M128 84V58c3-12 14-12 17 0v26z" />
      <path class="cut" d="M72 24h60V12H72z" />
    </svg>
    <p>${sentence}</p>
  </div>`;
