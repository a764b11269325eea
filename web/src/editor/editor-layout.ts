import {css} from 'lit';

import {framed} from './style/tool-group.js';

/**
 * The layout depends on the width of the editor itself; `--sw-editor-height` sets its height. The
 * pattern is always visible: scrolling panels are beside it, or below it in a narrow editor.
 */
export const editorLayout = css`
  :host {
    --height: var(--sw-editor-height, min(100dvh, 48rem));
    display: block;
    container-type: inline-size;
  }
  .workbench {
    position: relative;
    display: grid;
    grid:
      'header header header' auto
      'setup pattern report' minmax(0, 1fr) / 20rem minmax(0, 1fr) 24rem;
    height: var(--height);
    overflow: hidden;
    background: var(--sw-ground);
  }
  header {
    grid-area: header;
    display: flex;
    flex-wrap: wrap;
    align-items: center;
    gap: var(--sw-space-2);
    padding: var(--sw-space-2) var(--sw-space-4);
    border-bottom: 1px solid var(--sw-line);
    background: var(--sw-paper);
  }
  .gap {
    flex: 1;
  }
  .solving {
    display: flex;
    align-items: center;
    justify-content: end;
    gap: var(--sw-space-2);
  }
  .solving button {
    min-width: 5.5rem;
  }
  .solving sw-progress {
    overflow-x: clip; /* its bar lies below it */
    white-space: nowrap;
  }
  .solving [hidden] {
    display: inline-flex;
    visibility: hidden; /* its room stays */
  }
  .pattern {
    grid-area: pattern;
    display: grid;
    grid-template: auto auto minmax(0, 1fr) / minmax(0, 1fr);
    position: relative;
    min-height: 0;
  }
  sw-pattern,
  sw-drape-pane,
  sw-marker-pane {
    grid-row: 3;
  }
  :is([data-shows='garment'], [data-shows='cloth']) sw-pattern {
    display: none;
  }
  [data-shows='both'] {
    grid-template-columns: repeat(2, minmax(0, 1fr));
  }
  [data-shows='both'] > :not(sw-pattern, sw-drape-pane) {
    grid-column: 1 / -1;
  }
  [data-shows='both'] sw-pattern {
    --sw-foot-wrap: wrap;
    --sw-said-room: 100%;
  }
  [data-shows='both'] sw-drape-pane {
    border-left: 1px solid var(--sw-line);
  }
  .views {
    display: flex;
    gap: 1px;
    ${framed}
  }
  .views button {
    min-height: calc(var(--sw-target) - 6px); /* as high as what is beside it */
    padding: 0 calc(var(--sw-space-2) - 2px);
  }
  .views svg {
    display: none;
  }
  .side {
    display: contents;
  }
  section {
    overflow-y: auto;
    background: var(--sw-paper);
    scrollbar-width: thin;
  }
  .setup {
    grid-area: setup;
    border-right: 1px solid var(--sw-line);
  }
  .report {
    grid-area: report;
    border-left: 1px solid var(--sw-line);
  }
  .tabs {
    display: none;
  }
  /* the room that they take once there is an answer */
  sw-headline {
    min-height: 13rem;
    align-content: start;
  }
  sw-lens {
    display: block;
    min-height: 14.25rem;
  }
  /* over the pattern and in pictures: there is no room for words, nor in the header */
  @container (width < 90rem) {
    header {
      position: relative;
    }
    .views {
      position: absolute;
      z-index: 3;
      inset: calc(100% + 1px + var(--sw-space-1)) calc(var(--beside, 0px) + var(--sw-space-2)) auto
        auto;
    }
    .views button {
      width: var(--sw-target);
      min-height: var(--sw-target);
      padding: 0;
    }
    .views span {
      position: absolute;
      width: 1px;
      height: 1px;
      overflow: hidden;
      clip-path: inset(50%);
    }
    .views svg {
      display: block;
    }
    .pattern {
      --sw-views-room: calc(4 * var(--sw-target) + var(--sw-space-4));
    }
  }
  @container (88rem <= width < 90rem) {
    header {
      --beside: 24rem;
    }
  }
  @container (64rem <= width < 88rem) {
    .workbench {
      grid-template-columns: 19rem minmax(0, 1fr) 23rem;
    }
    header {
      --beside: 23rem;
    }
  }
  @container (width >= 90rem) {
    .solving sw-progress {
      min-width: 9rem;
      max-width: 9rem;
      display: grid;
      align-content: center;
      height: 2.4em; /* of two lines, so that nothing moves when there is one */
      line-height: 1.2;
      white-space: normal; /* the views want the room of a long sentence */
    }
  }
  @container (width >= 64rem) {
    /* what it says of seams is not what is asked there */
    .workbench:has([data-shows='cloth']) .report {
      display: none;
    }
    [data-shows='cloth'] {
      grid-column: pattern / report;
    }
    header:has(~ [data-shows='cloth']) {
      --beside: 0px;
    }
    sw-lens {
      position: sticky;
      bottom: 0;
      z-index: 1;
      border-top: 1px solid var(--sw-line);
    }
    sw-lens[wide] {
      position: absolute;
      inset: auto 0 0;
      grid-column: 2;
      grid-row: 2;
      border: 1px solid var(--sw-line);
      border-bottom: 0;
    }
    .workbench:has(sw-lens[wide]) .pattern {
      padding-bottom: 19rem; /* its height */
    }
  }
  @container (width < 64rem) {
    .side {
      grid-area: side;
      display: grid;
      grid-template-columns: minmax(0, 1fr);
      min-height: 0;
      background: var(--sw-paper);
    }
    .setup,
    .report {
      grid-area: auto;
    }
    header {
      gap: var(--sw-space-1);
    }
    .solving sw-progress {
      min-width: 6.5rem;
    }
    .solving button {
      min-width: 4.75rem;
    }
  }
  /* above each other: there is no room side by side */
  @container (width < 64rem) {
    [data-shows='both'] {
      grid-template: auto auto repeat(2, minmax(0, 1fr)) / minmax(0, 1fr);
    }
    [data-shows='both'] sw-drape-pane {
      --sw-views-room: 0px;
      grid-row: 4;
      border: 0;
      border-top: 1px solid var(--sw-line);
    }
  }
  /* beside it: how well it fits, then what is asked most often; the tables last */
  @container (40rem <= width < 64rem) {
    .workbench {
      grid: 'header header' auto 'pattern side' minmax(0, 1fr) / minmax(0, 1fr) 20rem;
    }
    header {
      --beside: 20rem;
    }
    .side {
      grid-auto-rows: max-content;
      overflow-y: auto;
      border-left: 1px solid var(--sw-line);
    }
    .setup,
    .report {
      display: contents;
    }
    sw-headline,
    sw-seam-table,
    sw-lens {
      order: 1;
    }
    .setup > * {
      order: 2;
    }
    sw-piece-table {
      order: 3;
    }
  }
  /* below it: one sheet at a time */
  @container (width < 40rem) {
    .workbench {
      grid: 'header' auto 'pattern' minmax(0, 1fr) 'side' auto / minmax(0, 1fr);
    }
    header {
      padding: var(--sw-space-1) var(--sw-space-2);
    }
    /* two rows: the steps and the solve, then what is worked on */
    .gap {
      flex: none;
      order: -1;
      width: 100%;
    }
    .solving,
    header > .icon:not(.keys) {
      order: -2;
    }
    .solving {
      flex: 1;
      min-width: 0;
    }
    .solving sw-progress {
      flex: 1;
      min-width: 0;
      text-overflow: ellipsis;
    }
    .solving [hidden] {
      display: none; /* nothing beside it would move */
    }
    .tabs {
      display: flex;
      border-top: 1px solid var(--sw-line);
    }
    .tabs button {
      flex: 1;
      min-height: 3rem;
      padding: 0;
      border: 0;
      border-radius: 0;
      background: none;
    }
    .tabs [aria-expanded='true'] {
      color: var(--sw-accent);
      font-weight: 600;
      box-shadow: inset 0 -3px var(--sw-accent);
    }
    section {
      order: -1;
      border: 0;
      border-top: 1px solid var(--sw-line);
    }
    .side section {
      display: none;
      height: min(22rem, calc(0.37 * var(--height)));
    }
    /* who is asked how the grain runs, or sews, has to see the pieces */
    .workbench:has(sw-grain-question[asks], sw-pattern[sews]) .side section {
      height: calc(0.15 * var(--height));
    }
    :is([data-sheet='print'], [data-sheet='cutting']) .setup,
    :is([data-sheet='fit'], [data-sheet='lists']) .report {
      display: block;
    }
    [data-sheet='print'] .setup > :not(sw-print-panel),
    [data-sheet='cutting'] .setup > sw-print-panel,
    [data-sheet='fit'] .report > sw-piece-table,
    [data-sheet='lists'] .report > :not(sw-piece-table) {
      display: none;
    }
  }
`;
