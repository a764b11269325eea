/** Layout of the fabric view, its tools and its messages. */
import {css} from 'lit';

import {progressLine} from '../style/progress-line.js';
import {wordlessTools} from '../style/tool-group.js';
import {viewFrame} from '../style/view-frame.js';

export const markerStyle = css`
  ${viewFrame} ${progressLine}
  :host {
    display: grid;
    grid-template: minmax(0, 1fr) / minmax(0, 1fr);
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
  .stage {
    margin: auto;
  }
  sw-marker-panel {
    grid-area: 1 / 2 / 4 / 3;
    overflow-y: auto;
    border-left: 1px solid var(--sw-line);
    background: var(--sw-paper);
    scrollbar-width: thin;
  }
  progress {
    inset: auto var(--panel) 0 0;
    width: calc(100% - var(--panel));
  }
  /* the choice of views lies over the bar, there is no room for it elsewhere */
  @container (width < 70rem) {
    .bar {
      grid-column: 1 / -1;
      padding-right: calc(var(--sw-views-room, 0px) + var(--sw-space-2));
    }
    sw-marker-panel {
      grid-row-start: 2;
      border-top: 1px solid var(--sw-line);
    }
  }
  @container (width < 60rem) {
    .pane {
      --panel: 17.5rem;
    }
    ${wordlessTools}
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
      scroll-margin-top: calc(var(--sw-target) + 1rem); /* of what stays above it */
    }
    sw-marker-panel {
      border-left: 0;
    }
    progress {
      position: sticky;
      inset: auto 0 0;
      width: 100%;
    }
    .bar {
      position: sticky; /* beside the choice of views, which stays, too */
      z-index: 1;
      top: 0;
      padding: var(--sw-space-1) 0 var(--sw-space-1) var(--sw-space-2);
      background: var(--sw-ground);
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
