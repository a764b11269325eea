import {css} from 'lit';

export const importStyle = css`
  dialog {
    width: min(64rem, calc(100vw - 2rem));
  }
  dialog.question {
    width: min(30rem, calc(100vw - 2rem));
  }
  footer p {
    flex: 1 1 6rem;
  }
  footer .primary {
    min-width: 6rem;
  }
  h2 {
    min-width: 0;
    font-size: var(--sw-text-large);
    overflow-wrap: anywhere;
  }
  header button {
    flex: none;
  }
  .body {
    display: grid;
    grid-template-columns: 17rem minmax(0, 1fr);
    min-height: 0;
  }
  .settings,
  .pieces {
    min-height: 0;
    overflow-y: auto;
    padding: var(--sw-space-4);
    scrollbar-width: thin;
  }
  .settings {
    display: grid;
    align-content: start;
    gap: var(--sw-space-6);
    border-right: 1px solid var(--sw-line);
  }
  section {
    display: grid;
    gap: var(--sw-space-2);
  }
  section.doubtful {
    margin: calc(-1 * var(--sw-space-2));
    padding: var(--sw-space-2);
    border-radius: var(--sw-radius);
    background: var(--sw-tint);
  }
  .units {
    display: grid;
    grid-template-columns: repeat(2, minmax(0, 1fr));
    gap: var(--sw-space-2);
  }
  .units button {
    display: grid;
    gap: 0;
    justify-content: start;
    justify-items: start;
    padding: var(--sw-space-1) var(--sw-space-3);
  }
  small,
  .notes {
    font-size: var(--sw-text);
  }
  .notes {
    display: grid;
    gap: var(--sw-space-2);
    margin: 0;
    padding: 0 0 0 var(--sw-space-4);
    overflow-wrap: anywhere;
  }
  section label input {
    color: var(--sw-ink);
  }
  .grid {
    display: grid;
    grid-template-columns: repeat(auto-fit, minmax(6.5rem, 1fr));
    gap: var(--sw-space-2) var(--sw-space-3);
  }
  .sheet {
    display: block;
    width: 100%;
    max-height: 22rem;
    margin-bottom: var(--sw-space-4);
  }
  .page {
    cursor: grab;
    touch-action: none;
  }
  .page.dragged {
    cursor: grabbing;
    opacity: 0.7;
  }
  .sheet:has(.dragged) .page:not(.dragged) rect {
    fill: none;
  }
  .page.dragged rect {
    stroke: var(--sw-accent);
    stroke-width: 2;
  }
  .back {
    display: flex;
    flex-wrap: wrap;
    gap: var(--sw-space-1);
  }
  .page rect {
    fill: var(--sw-raised);
    stroke: var(--sw-line);
    stroke-width: 1;
    vector-effect: non-scaling-stroke;
  }
  .page:hover rect {
    fill: var(--sw-tint);
  }
  .page text {
    fill: var(--sw-soft);
  }
  .sheet path {
    pointer-events: none;
  }
  .sheet .sewn {
    fill: none;
  }
  .sheet .open {
    stroke: var(--sw-error);
    stroke-width: 3;
  }
  .pieces {
    position: relative;
    padding-bottom: 0;
  }
  .over {
    display: flex;
    flex-wrap: wrap;
    align-items: baseline;
    gap: var(--sw-space-1) var(--sw-space-3);
  }
  .over .soft {
    flex: 1;
  }
  .pieces ul {
    display: flex;
    flex-wrap: wrap;
    align-items: stretch;
    gap: var(--sw-space-3);
    margin: var(--sw-space-3) 0 var(--sw-space-4);
    padding: 0;
    list-style: none;
  }
  .pieces li {
    display: grid;
    grid-template-rows: minmax(0, 1fr) auto auto;
    gap: var(--sw-space-1);
    width: min-content;
    min-width: 10.5rem;
    padding: var(--sw-space-2);
    border: 1px solid var(--sw-line);
    border-radius: var(--sw-radius);
    background: var(--sw-raised);
    content-visibility: auto;
    contain-intrinsic-size: 10.5rem 14rem;
  }
  .pieces label {
    display: grid;
    grid-template-rows: minmax(0, 1fr) auto;
    gap: var(--sw-space-2);
    color: inherit;
    cursor: pointer;
  }
  .pieces li > .soft {
    font-size: var(--sw-text);
    overflow-wrap: anywhere;
  }
  .shape {
    display: grid;
    place-items: center;
    padding: var(--sw-space-1);
  }
  .name {
    display: flex;
    align-items: center;
    gap: var(--sw-space-2);
    font-weight: 600;
    overflow-wrap: anywhere;
  }
  .name input {
    flex: none;
  }
  path {
    fill: none;
    stroke: var(--sw-ink);
    stroke-width: 1.25;
    vector-effect: non-scaling-stroke;
  }
  .sewn {
    fill: var(--sw-tint);
    fill-rule: evenodd;
  }
  .cut,
  .marks {
    stroke: var(--sw-strong-line);
    stroke-width: 1;
  }
  .fold {
    stroke: var(--sw-accent);
    stroke-width: 2;
    stroke-dasharray: 8 3 2 3;
  }
  .doubtful {
    stroke: var(--sw-accent);
    stroke-width: 2;
  }
  .pieces li > p {
    margin: 0;
  }
  .off path {
    stroke: var(--sw-strong-line);
    stroke-dasharray: 3 3;
    fill: none;
  }
  .ruler {
    position: sticky;
    bottom: 0;
    display: flex;
    align-items: center;
    gap: var(--sw-space-2);
    margin: 0 calc(-1 * var(--sw-space-4));
    padding: var(--sw-space-2) var(--sw-space-4);
    border-top: 1px solid var(--sw-line);
    background: var(--sw-paper);
  }
  .ruler svg {
    flex: none;
  }
  .kinds {
    display: grid;
    gap: var(--sw-space-3);
    padding: var(--sw-space-4);
  }
  .kinds button {
    display: grid;
    justify-items: start;
    gap: 0;
    justify-content: start;
    padding: var(--sw-space-3) var(--sw-space-4);
    text-align: left;
    white-space: normal;
  }
  @media (width < 48rem) {
    dialog {
      width: 100vw;
      max-height: 100dvh;
      margin: auto 0 0;
      border-width: 1px 0 0;
      border-radius: calc(2 * var(--sw-radius)) calc(2 * var(--sw-radius)) 0 0;
    }
    dialog.question {
      width: 100vw;
    }
    .body {
      display: block;
      overflow-y: auto;
    }
    .settings,
    .pieces {
      overflow: visible;
    }
    .settings {
      border-right: 0;
      border-bottom: 1px solid var(--sw-line);
    }
    .pieces ul {
      gap: var(--sw-space-2);
    }
    .pieces li {
      flex: 1 1 auto;
      min-width: 9.5rem;
    }
  }
`;
