/** Styles of the fabric and of the pieces on it. */
import {css} from 'lit';

export const sheetStyle = css`
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
  .piece.pointed .line {
    stroke-width: 2;
  }
  .piece.selected .line {
    stroke: #24507a;
    stroke-width: 3;
  }
  .piece.bad .line {
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
