import {css} from 'lit';

import {toolGroup} from '../style/tool-group.js';

export const paneStyle = css`
  ${toolGroup}
  :host {
    display: grid;
    grid-template: auto minmax(0, 1fr) auto / minmax(0, 1fr);
    position: relative;
    overflow: hidden;
    min-height: 0;
    background: var(--sw-ground);
  }
  sw-toolbar {
    grid-area: 1 / 1;
    display: var(--sw-tools, flex);
  }
  .application {
    grid-area: 2 / 1;
    position: relative;
  }
  .application:focus-visible {
    outline-offset: -2px;
  }
  sw-toolbar {
    padding: var(--sw-space-2) var(--sw-space-3);
  }
  ::slotted([slot='notice']) {
    grid-area: 2 / 1;
    place-self: start center;
    z-index: 2;
    margin-top: var(--sw-space-2);
  }
  sw-wipe-handle,
  sw-ties-menu {
    grid-area: 2 / 1 / 3 / 2;
  }
  .foot {
    grid-area: 3 / 1;
    display: var(--sw-tools, flex);
    min-height: 4rem; /* for two lines of a hint: the pattern must not move under the next click */
    align-items: center;
    justify-content: space-between;
    gap: var(--sw-space-1) var(--sw-space-4);
    flex-wrap: nowrap;
    padding: var(--sw-space-1) var(--sw-space-3) var(--sw-space-2);
  }
  .foot:has(.bar) {
    flex-wrap: wrap;
  }
  .foot:has(.bar) sw-tool-hint {
    block-size: 3.9em; /* for three lines, whatever is said */
    overflow-y: auto;
  }
  .bar {
    flex: 1 1 100%;
    min-width: 0;
  }
  .foot[hidden] {
    display: none;
  }
  sw-tool-hint,
  .said {
    flex: 1;
  }
  .said {
    position: relative; /* a hint lies over it */
    display: grid;
    align-content: center;
    align-self: stretch;
  }
  @media (pointer: coarse) {
    .zoom {
      display: none; /* two fingers do it, or the menu of sizes */
    }
  }
  @container (width < 40rem) {
    sw-toolbar {
      padding: var(--sw-space-1) var(--sw-space-2);
    }
    .foot {
      flex-wrap: wrap;
      padding: 0 var(--sw-space-2) var(--sw-space-1);
    }
    sw-tool-hint {
      flex-basis: 100%;
    }
    /* these tools need all the room for the pieces */
    .foot:has(.bar) .view {
      display: none;
    }
  }
  :host([purpose='place']) .foot {
    flex-wrap: wrap;
  }
  :host([purpose='place']) sw-tool-hint {
    flex: 1 1 16rem;
  }
  .view {
    flex: none;
    flex-wrap: nowrap;
    margin-left: auto;
  }
  .view button {
    width: var(--sw-target);
    padding: 0;
  }
`;
