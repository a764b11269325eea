import {css} from 'lit';

/**
 * By the width of the editor itself, wherever it stands. `--sw-editor-height` is how high it is where there is
 * room for columns; where there is none, it is as high as what it holds.
 */
export const editorLayout = css`
  :host {
    --height: var(--sw-editor-height, min(100dvh, 48rem));
    display: block;
    container-type: inline-size;
  }
  .desk {
    position: relative;
    display: grid;
    grid:
      'header header header' auto
      'setup pattern report' minmax(0, 1fr) / 20rem minmax(0, 1fr) 24rem;
    height: var(--height);
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
    gap: var(--sw-space-2);
  }
  sw-progress {
    flex: 1;
  }
  .icon {
    width: 2rem;
    padding: 0;
  }
  .pattern {
    grid-area: pattern;
    display: grid;
    grid-template-rows: auto minmax(0, 1fr);
    position: relative;
    min-height: 0;
  }
  sw-pattern {
    grid-row: 2;
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
  .notice {
    position: absolute;
    left: 50%;
    bottom: var(--sw-space-4);
    translate: -50% 0;
    display: flex;
    align-items: center;
    gap: var(--sw-space-3);
    width: max-content;
    max-width: min(36rem, calc(100% - 2rem));
    padding: var(--sw-space-2) var(--sw-space-2) var(--sw-space-2) var(--sw-space-4);
    border: 1px solid var(--sw-line);
    border-radius: var(--sw-radius);
    background: var(--sw-raised);
  }
  .notice.error {
    border-color: var(--sw-bad);
    background: var(--sw-bad-tint);
  }
  @container (width >= 64rem) {
    sw-lens {
      position: sticky;
      top: 0;
      z-index: 1;
      border-bottom: 1px solid var(--sw-line);
    }
    sw-lens[wide] {
      position: absolute;
      inset: auto 24rem 0 20rem;
      border: 1px solid var(--sw-line);
      border-bottom: 0;
    }
    .pattern:has(+ .report sw-lens[wide]) {
      padding-bottom: 19rem; /* its height */
    }
  }
  @container (width < 64rem) {
    .desk {
      display: flex;
      flex-direction: column;
      height: auto;
      min-height: var(--height);
      background: var(--sw-paper);
    }
    .pattern {
      height: calc(0.62 * var(--height));
      min-height: 22rem;
    }
    /* what is asked most often comes first: how well it fits, then the print; the tables last */
    .setup,
    .report {
      display: contents;
    }
    sw-headline,
    sw-lens {
      order: 1;
    }
    .setup > * {
      order: 2;
    }
    sw-tables {
      order: 3;
    }
    .gap {
      display: none;
    }
    .solving {
      flex: 1 0 100%;
    }
  }
  /* three rows: the steps, what else there is, the solve */
  @container (width < 40rem) {
    .gap,
    header > .icon {
      order: -1;
    }
    .gap {
      display: block;
    }
  }
`;
