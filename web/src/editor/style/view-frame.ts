/** A view with a row of tools above it, and a row of text and tools below. */
import {css} from 'lit';

import {framed, toolGroup} from './tool-group.js';

export const viewFrame = css`
  ${toolGroup}
  :host {
    overflow: hidden;
    min-height: 0;
    container-type: size;
    background: var(--sw-ground);
  }
  .application:focus-visible {
    outline-offset: -2px;
  }
  ::slotted([slot='notice']) {
    grid-area: 2 / 1;
    place-self: start center;
    z-index: 2;
    margin-top: var(--sw-space-2);
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
    flex: none;
    flex-wrap: nowrap;
    margin-left: auto;
  }
  .said {
    display: flex;
    flex-wrap: wrap;
    align-items: center;
    gap: 0 var(--sw-space-2);
    min-height: calc(var(--sw-target) + 6px);
    max-width: 100%;
    color: var(--sw-soft);
  }
  .told {
    display: inline-flex;
    flex-wrap: wrap;
    align-items: center;
    gap: 0 var(--sw-space-2);
    ${framed}
    padding: 2px var(--sw-space-2);
    font-size: var(--sw-text);
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
    min-width: 9.5em; /* the button beside it stays where it is */
    font-variant-numeric: tabular-nums;
  }
`;
