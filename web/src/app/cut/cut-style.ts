import {css} from 'lit';

export const cutStyle = css`
  dialog {
    width: min(56rem, calc(100vw - 2rem));
  }
  footer p {
    flex: 1 1 12rem;
  }
  h2 {
    font-size: var(--sw-text-large);
  }
  .body {
    display: grid;
    grid-template-columns: 18rem minmax(0, 1fr);
    min-height: 0;
    overflow-y: auto;
  }
  .settings {
    display: grid;
    align-content: start;
    gap: var(--sw-space-4);
    padding: var(--sw-space-4);
    border-right: 1px solid var(--sw-line);
  }
  .files {
    display: grid;
    grid-template-columns: repeat(4, minmax(0, 1fr));
    gap: var(--sw-space-1);
  }
  .inks {
    display: grid;
    grid-template-columns: repeat(3, minmax(0, 1fr));
    gap: var(--sw-space-1);
  }
  .files button,
  .inks button {
    padding: 0 var(--sw-space-1);
  }
  .file {
    display: grid;
    gap: var(--sw-space-2);
  }
  .lengths {
    display: grid;
    grid-template-columns: repeat(2, minmax(0, 1fr));
    gap: var(--sw-space-3);
    align-items: end;
  }
  .lengths p {
    grid-column: 1 / -1;
  }
  figure {
    display: grid;
    grid-template-rows: minmax(0, 1fr) auto;
    gap: var(--sw-space-3);
    min-height: 20rem;
    margin: 0;
    padding: var(--sw-space-4);
    background: var(--sw-ground);
  }
  figure.waiting .map {
    opacity: 0.5;
  }
  .map {
    width: 100%;
    height: 100%;
    max-height: 26rem;
  }
  .page {
    fill: var(--sw-raised);
  }
  .joint {
    fill: none;
    stroke: var(--sw-strong-line); /* over the pieces, too */
    stroke-width: 1;
    vector-effect: non-scaling-stroke;
  }
  .pieces {
    fill: color-mix(in srgb, var(--sw-accent) 22%, transparent);
    fill-rule: evenodd;
    stroke: var(--sw-accent);
    stroke-width: 1;
    vector-effect: non-scaling-stroke;
  }
  .print {
    fill-rule: evenodd;
  }
  .pieces.bare {
    fill: none;
  }
  .map text {
    fill: var(--sw-soft);
    stroke: var(--sw-raised); /* over the print */
    stroke-width: 0.2em;
    paint-order: stroke;
  }
  figcaption {
    text-align: center;
  }
  figcaption:has(.error) {
    display: grid;
    grid-row: 1 / -1;
    place-content: center;
    justify-items: center;
    gap: var(--sw-space-3);
    max-width: 22rem;
    margin: auto;
  }
  figcaption b {
    font-size: var(--sw-text-large);
  }
  @media (width < 44rem) {
    dialog {
      width: 100vw;
      max-height: 100dvh;
      margin: auto 0 0;
      border-width: 1px 0 0;
      border-radius: calc(2 * var(--sw-radius)) calc(2 * var(--sw-radius)) 0 0;
    }
    .body {
      grid-template-columns: minmax(0, 1fr);
    }
    .settings {
      border-right: 0;
      border-bottom: 1px solid var(--sw-line);
    }
    figure {
      min-height: 16rem;
    }
    footer p {
      flex-basis: 100%;
    }
  }
`;
