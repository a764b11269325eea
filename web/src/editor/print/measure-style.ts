import {css} from 'lit';

export const measureStyle = css`
  dialog {
    width: min(94vw, 40rem);
    max-height: 94vh;
    padding: var(--sw-space-4);
    border: 1px solid var(--sw-line);
    border-radius: var(--sw-radius);
    background: var(--sw-paper);
    color: var(--sw-ink);
  }
  dialog::backdrop {
    background: rgb(0 0 0 / 0.4);
  }
  .inside {
    display: grid;
    gap: var(--sw-space-3);
  }
  header {
    display: flex;
    align-items: center;
    justify-content: space-between;
  }
  .picture {
    position: relative;
    justify-self: center;
    cursor: crosshair;
    touch-action: none;
  }
  svg.print {
    display: block;
    width: 100%;
    height: 100%;
  }
  line {
    vector-effect: non-scaling-stroke;
    stroke-width: 2;
    stroke: #c22318;
  }
  line.casing {
    stroke: #fff;
    stroke-width: 5;
  }
  .entry {
    display: grid;
    grid-template-columns: minmax(0, 1fr) auto;
    gap: var(--sw-space-2);
    align-items: end;
  }
`;
