import {css} from 'lit';

/** Still read out. */
export const unseen = css`
  position: absolute;
  width: 1px;
  height: 1px;
  overflow: hidden;
  clip-path: inset(50%);
`;

export const pageLayout = css`
  :host {
    display: grid;
    grid:
      'header header header' auto
      'setup pattern report' minmax(0, 1fr) / 20rem minmax(0, 1fr) 24rem;
    height: 100dvh;
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
  h1 {
    margin: 0 var(--sw-space-2) 0 0;
    font-size: var(--sw-text-large);
    font-weight: 650;
    letter-spacing: -0.01em;
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
  main {
    grid-area: pattern;
    display: grid;
    grid-template-rows: auto minmax(0, 1fr);
    position: relative;
    min-height: 0;
  }
  sw-pattern {
    grid-row: 2;
  }
  aside {
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
  @media (width >= 64rem) {
    sw-lens[wide] {
      position: fixed;
      inset: auto 24rem 0 20rem;
      border: 1px solid var(--sw-line);
      border-bottom: 0;
    }
    main:has(+ .report sw-lens[wide]) {
      padding-bottom: 19rem; /* its height */
    }
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
  /* words give way to icons where there is no room for them; German ones are longer */
  @media (width < 80rem) {
    header .label {
      ${unseen}
    }
  }
  @media (width < 114rem) {
    header:lang(de) .label {
      ${unseen}
    }
  }
  @media (width < 64rem) {
    :host {
      display: flex;
      flex-direction: column;
      height: auto;
      min-height: 100dvh;
      background: var(--sw-paper);
    }
    main {
      height: 62dvh;
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
  /* three rows: the steps, the garment and its files, the solve */
  @media (width < 40rem) {
    h1,
    sw-recent-menu,
    .gap,
    header > .icon,
    sw-settings {
      order: -1;
    }
    .gap {
      display: block;
    }
    sw-garment-choice {
      flex: 1 1 9rem;
      min-width: 0;
    }
  }
`;
