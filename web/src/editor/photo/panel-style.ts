import {css} from 'lit';

export const panelStyle = css`
  :host {
    display: grid;
    align-content: start;
    gap: var(--sw-space-4);
  }
  section {
    display: grid;
    gap: var(--sw-space-2);
  }
  .row {
    display: flex;
    flex-wrap: wrap;
    gap: var(--sw-space-2);
  }
  .row > .soft {
    flex-basis: 100%;
  }
  .row label {
    margin-right: var(--sw-space-2);
  }
  .beside {
    display: grid;
    grid-template-columns: repeat(2, minmax(0, 1fr)) var(--sw-target);
    align-items: end;
    gap: var(--sw-space-2);
  }
  input[type='range'] {
    width: 100%;
    min-height: var(--sw-target);
    margin: 0;
    accent-color: var(--sw-accent);
  }
  .groups {
    display: grid;
  }
  .group {
    display: grid;
    grid-template-columns: auto 3rem 5rem minmax(0, 1fr);
    align-items: center;
    gap: var(--sw-space-2);
    min-height: 1.75rem;
    color: inherit;
  }
  .group svg {
    width: 100%;
    height: 0.4rem;
    fill: #2e7d4f;
  }
  .group svg[data-verdict='almost'] {
    fill: #b7791f;
  }
  .group svg[data-verdict='has not'] {
    fill: #c22318;
  }
  .group .track {
    fill: color-mix(in srgb, var(--sw-ink) 10%, transparent);
  }
`;
