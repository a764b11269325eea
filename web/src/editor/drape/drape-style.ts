import {css} from 'lit';

import {progressLine} from '../style/progress-line.js';
import {viewFrame} from '../style/view-frame.js';

export const drapeStyle = css`
  ${viewFrame} ${progressLine}
  :host {
    display: grid;
    grid-template: auto minmax(0, 1fr) auto / minmax(0, 1fr);
    position: relative;
  }
  .application {
    grid-area: 2 / 1;
    position: relative;
  }
  .wipe {
    grid-area: 2 / 1;
    position: relative;
    pointer-events: none;
  }
  .bar,
  .foot,
  progress {
    z-index: 1;
  }
  .bar {
    margin-right: var(--sw-views-room, 0); /* of what lies over it */
  }
  .foot {
    align-items: end;
  }
  .group select {
    flex: none;
    width: auto;
    min-height: var(--sw-target);
    border-color: transparent;
    background: transparent;
    color: var(--sw-ink);
  }
  .truth {
    font-size: var(--sw-text-small);
  }
  @media (prefers-reduced-motion: reduce) {
    .turntable {
      display: none;
    }
  }
  @container (height < 15rem) {
    .bar {
      display: none; /* where there is hardly room for the garment */
    }
  }
  @container (width < 26rem) {
    .bar,
    .foot {
      padding: var(--sw-space-1) var(--sw-space-2);
    }
    .foot {
      gap: 0 var(--sw-space-2);
    }
    .said {
      min-height: 0;
    }
    .zoom,
    .truth {
      display: none;
    }
  }
`;
