import {css} from 'lit';

/** The row of views, which stays where it is whatever view is shown. */
const viewsRow = css`
  .views {
    grid-area: 1 / 1 / 2 / -1;
    display: flex;
    gap: var(--sw-space-1);
    padding: var(--sw-space-1) var(--sw-space-3);
    border-bottom: 1px solid var(--sw-line);
    background: var(--sw-paper);
  }
  .views button {
    position: relative;
    padding: 0 var(--sw-space-3);
    color: var(--sw-soft);
  }
  .views button[aria-pressed='true'] {
    border-color: transparent;
    background: color-mix(in srgb, var(--sw-ink) 7%, transparent);
    color: var(--sw-ink);
    font-weight: 600;
  }
  /* as wide as in bold, so that nothing moves with the choice */
  .views button::after {
    content: attr(data-label);
    height: 0;
    overflow: hidden;
    visibility: hidden;
    font-weight: 600;
  }
  .views button {
    display: inline-grid;
    align-content: center;
  }
`;

/**
 * The layout depends on the width of the editor itself; `--sw-editor-height` sets its height. The
 * view is always visible: scrolling panels are beside it, or below it in a narrow editor.
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
      'setup pattern report' minmax(0, 1fr) / 18rem minmax(0, 1fr) 24rem;
    height: var(--height);
    overflow: hidden;
    background: var(--sw-ground);
  }
  header {
    grid-area: header;
    position: relative;
    display: flex;
    flex-wrap: wrap;
    align-items: center;
    gap: var(--sw-space-1) var(--sw-space-2);
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
  .solving sw-progress {
    display: grid;
    align-content: center;
    width: 13rem;
    min-width: 0;
    height: 2.4em; /* of two lines, so that nothing moves when there is one */
    overflow-x: clip; /* its bar lies below it */
    line-height: 1.2;
    white-space: nowrap;
  }
  .solving [hidden] {
    display: inline-flex;
    visibility: hidden; /* its room stays */
  }
  .pattern {
    grid-area: pattern;
    display: grid;
    grid-template: auto auto auto minmax(0, 1fr) / minmax(0, 1fr);
    position: relative;
    min-height: 0;
  }
  ${viewsRow}
  sw-units-question {
    grid-area: 2 / 1 / 3 / -1;
  }
  sw-grain-question {
    grid-area: 3 / 1 / 4 / -1;
  }
  sw-pattern,
  sw-drape-pane,
  sw-marker-pane {
    grid-area: 4 / 1;
  }
  slot[name='welcome'] {
    grid-area: 6 / 1 / 7 / -1;
    display: block;
  }
  :is([data-shows='garment'], [data-shows='marker']) sw-pattern {
    display: none;
  }
  /* the garment, and the pieces in a strip below it; their tools come with the view Pattern */
  [data-shows='both'] {
    grid-template-rows: auto auto auto minmax(0, 1fr) clamp(8rem, 26%, 16rem);
  }
  [data-shows='both'] sw-pattern {
    --sw-tools: none;
    grid-area: 5 / 1;
    border-top: 1px solid var(--sw-line);
  }
  @media (height < 32rem) {
    [data-shows='both'] {
      grid-template-rows: auto auto auto minmax(0, 1fr);
    }
    [data-shows='both'] sw-pattern {
      display: none; /* a strip of pieces would leave hardly any room for the garment */
    }
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
    min-height: 14.5rem;
  }
  @container (width >= 120rem) {
    .workbench {
      grid-template-columns: 22rem minmax(0, 1fr) 26rem;
    }
    [data-shows='both'] {
      grid-template: auto auto auto minmax(0, 1fr) / minmax(0, 5fr) minmax(0, 4fr);
    }
    [data-shows='both'] sw-pattern {
      grid-area: 4 / 2;
      border: 0;
      border-left: 1px solid var(--sw-line);
    }
  }
  @container (64rem <= width < 84rem) {
    .workbench {
      grid-template-columns: 16rem minmax(0, 1fr) 23rem;
    }
  }
  @container (width >= 64rem) {
    /* the report on seams does not concern the layout, which takes its room */
    .workbench:has([data-shows='marker']) .report {
      display: none;
    }
    [data-shows='marker'] {
      grid-column: pattern / report;
    }
    sw-headline {
      position: sticky;
      top: 0;
      z-index: 1;
      max-height: 50%;
      overflow-y: auto;
      background: var(--sw-paper);
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
      grid-auto-rows: max-content;
      min-height: 0;
      overflow-y: auto;
      background: var(--sw-paper);
    }
    .setup,
    .report {
      display: contents;
    }
    header {
      gap: var(--sw-space-1);
      padding: var(--sw-space-2);
    }
    .solving sw-progress {
      width: 6.5rem;
      white-space: normal;
    }
    .solving button {
      padding: 0 var(--sw-space-2);
    }
  }
  /* beside it: how well it fits, then pattern and fabric; the tables last */
  @container (40rem <= width < 64rem) {
    .workbench {
      grid: 'header header' auto 'pattern side' minmax(0, 1fr) / minmax(0, 1fr) 20rem;
    }
    .side {
      border-left: 1px solid var(--sw-line);
    }
    slot[name='garment'] {
      display: block;
    }
    sw-headline,
    sw-seam-table,
    sw-lens {
      order: 1;
    }
    sw-seam-table {
      min-height: 14rem; /* as sw-headline */
    }
    .setup > * {
      order: 2;
    }
    sw-piece-table {
      order: 3;
    }
  }
  /* below it: the headline, one sheet at a time, and the tabs */
  @container (width < 40rem) {
    .keys {
      display: none; /* Commands lists the keys, too */
    }
    .workbench {
      grid: 'header' auto 'pattern' minmax(0, 1fr) 'side' auto / minmax(0, 1fr);
    }
    header {
      flex-wrap: nowrap;
      gap: 0;
      padding: var(--sw-space-1) var(--sw-space-2);
    }
    .views {
      justify-content: safe center;
      gap: 0;
      padding: 0 var(--sw-space-1);
      overflow-x: auto;
      scrollbar-width: none;
    }
    .views button {
      flex: none;
      padding: 0 var(--sw-space-2);
    }
    /* over the picture, while it is at work */
    .solving {
      position: absolute;
      z-index: 3;
      inset: calc(100% + var(--sw-target) + var(--sw-space-3)) var(--sw-space-2) auto auto;
      flex-direction: column-reverse; /* the button fits beside the tools of the view */
      align-items: end;
      gap: 0;
      pointer-events: none;
    }
    .solving sw-progress {
      width: 12rem;
      height: auto;
      padding: 0 var(--sw-space-2) var(--sw-space-1);
      white-space: nowrap;
    }
    .solving button {
      pointer-events: auto;
    }
    .side {
      max-height: calc(0.42 * var(--height));
      border-top: 1px solid var(--sw-line);
    }
    /* its room before its content is there */
    .workbench:not([data-sheet='none']) .side {
      height: calc(0.42 * var(--height));
    }
    /* the pieces have to be in sight for a question about them, and for sewing */
    .workbench:has(sw-grain-question[asks], sw-pattern[sews]) .side {
      max-height: calc(0.15 * var(--height));
    }
    sw-headline {
      order: -1;
    }
    .tabs {
      order: 1;
      position: sticky;
      bottom: 0;
      z-index: 2;
      display: flex;
      border-top: 1px solid var(--sw-line);
      background: var(--sw-paper);
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
      font-weight: 600;
      box-shadow: inset 0 -2px var(--sw-ink);
    }
    .tabs .goal {
      color: var(--sw-accent);
      font-weight: 600;
    }
    slot[name='goal'] {
      display: none;
    }
    /* the headline alone, or the whole reason of a failure */
    .workbench:not([data-sheet='seams']) sw-headline {
      position: sticky;
      top: 0;
      z-index: 1;
      min-height: 3.25rem;
      padding-block: var(--sw-space-3);
      background: var(--sw-paper);
    }
    .workbench:not([data-sheet='seams']) sw-headline:not([failed]) {
      --sw-sentences: none;
      max-height: 3.25rem;
      overflow: hidden;
    }
    .workbench:not([data-sheet='seams']) :is(sw-lens, sw-seam-table, sw-piece-table),
    .workbench:not([data-sheet='fabric']) sw-print-panel,
    .workbench:not([data-sheet='pattern'])
      :is(slot[name='garment'], sw-symmetry-panel, sw-solve-panel) {
      display: none;
    }
  }
`;
