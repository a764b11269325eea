import {css} from 'lit';

export const clothStyle = css`
  :host {
    display: grid;
    grid-template: minmax(0, 1fr) / minmax(0, 1fr);
    overflow: hidden;
    min-height: 0;
    container-type: size;
    background: var(--sw-ground);
  }
  .pane {
    --panel: 21rem;
    position: relative;
    display: grid;
    grid-template: auto minmax(0, 1fr) auto / minmax(0, 1fr) var(--panel);
    min-height: 0;
  }
  .application {
    grid-area: 2 / 1;
    display: grid;
    overflow: auto;
    scrollbar-width: thin;
  }
  .application:focus-visible {
    outline-offset: -2px;
  }
  .stage {
    margin: auto;
  }
  ::slotted([slot='notice']) {
    grid-area: 2 / 1;
    place-self: start center;
    z-index: 2;
    margin-top: var(--sw-space-2);
  }
  sw-cloth-panel {
    grid-area: 1 / 2 / 4 / 3;
    overflow-y: auto;
    border-left: 1px solid var(--sw-line);
    background: var(--sw-paper);
    scrollbar-width: thin;
  }
  .bar,
  .foot {
    display: flex;
    flex-wrap: wrap;
    align-items: center;
    gap: var(--sw-space-1) var(--sw-space-2);
    padding: var(--sw-space-2) var(--sw-space-3);
  }
  .bar {
    grid-area: 1 / 1;
  }
  .foot {
    grid-area: 3 / 1;
    justify-content: space-between;
  }
  .foot > .group {
    margin-left: auto;
  }
  .group {
    display: flex;
    align-items: center;
    gap: 1px;
    padding: 2px;
    border: 1px solid var(--sw-line);
    border-radius: calc(var(--sw-radius) + 2px);
    background: var(--sw-paper);
  }
  .group button {
    padding: 0 var(--sw-space-2);
  }
  .group .icon {
    width: var(--sw-target);
    padding: 0;
  }
  .said {
    display: flex;
    align-items: center;
    min-height: calc(var(--sw-target) + 6px);
    max-width: 100%;
    color: var(--sw-soft);
  }
  .told {
    display: inline-flex;
    flex-wrap: wrap;
    align-items: center;
    gap: 0 var(--sw-space-2);
    padding: 2px var(--sw-space-2);
    border: 1px solid var(--sw-line);
    border-radius: calc(var(--sw-radius) + 2px);
    background: var(--sw-paper);
    color: var(--sw-soft);
  }
  .told.bad {
    border-color: var(--sw-bad);
    background: var(--sw-bad-tint);
    color: var(--sw-ink);
  }
  .told button {
    min-height: calc(var(--sw-target) - 4px);
  }
  .numbers {
    min-width: 8em; /* the button beside it stays where it is */
    font-variant-numeric: tabular-nums;
  }
  progress {
    position: absolute;
    inset: auto var(--panel) 0 0;
    appearance: none;
    width: calc(100% - var(--panel));
    height: 3px;
    border: 0;
    background: transparent;
  }
  progress::-webkit-progress-bar {
    background: transparent;
  }
  progress::-webkit-progress-value {
    background: var(--sw-accent);
  }
  progress::-moz-progress-bar {
    background: var(--sw-accent);
  }
  /* the cloth */
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
  .flaw.draft {
    stroke-dasharray: 4 3;
  }
  /* the choice of views lies over the bar, there is no room for it elsewhere */
  @container (width < 70rem) {
    .bar {
      grid-column: 1 / -1;
      padding-right: calc(var(--sw-views-room, 0px) + var(--sw-space-2));
    }
    sw-cloth-panel {
      grid-row-start: 2;
      border-top: 1px solid var(--sw-line);
    }
  }
  @container (width < 60rem) {
    .pane {
      --panel: 17.5rem;
    }
    .tool span {
      position: absolute;
      width: 1px;
      height: 1px;
      overflow: hidden;
      clip-path: inset(50%);
    }
    .group .tool {
      width: var(--sw-target);
      padding: 0;
    }
  }
  /* above each other: there is no room side by side */
  @container (width < 42rem) {
    .pane {
      display: block;
      overflow-y: auto;
    }
    .application {
      height: calc(
        100cqh - 2 * (var(--sw-target) + 1rem) - 3.5rem
      ); /* what there is to buy is seen */
      min-height: 12rem;
    }
    sw-cloth-panel {
      border-left: 0;
    }
    progress {
      position: sticky;
      inset: auto 0 0;
      width: 100%;
    }
    .bar {
      padding: var(--sw-space-1) 0 var(--sw-space-1) var(--sw-space-2);
    }
    .foot {
      flex-wrap: nowrap;
      padding: var(--sw-space-1) var(--sw-space-2);
    }
    .said {
      line-height: 1.25;
    }
  }
`;
