import {css} from 'lit';

export const panelStyle = css`
  .buy {
    font-size: var(--sw-text-title);
    line-height: 1.2;
  }
  .stale > :not(.fields) {
    opacity: 0.5;
  }
  ul {
    display: grid;
    gap: 2px;
    margin: 0;
    padding: 0;
    list-style: none;
  }
  .facts {
    color: var(--sw-soft);
  }
  .facts svg {
    width: 0.875rem;
    height: 0.875rem;
    vertical-align: -0.15em;
  }
  .fields {
    display: grid;
    gap: var(--sw-space-3);
  }
  .fields select {
    color: var(--sw-ink);
  }
  .pair {
    display: grid;
    grid-template-columns: repeat(2, minmax(0, 1fr));
    align-items: end;
    gap: var(--sw-space-3) var(--sw-space-2);
  }
  .note {
    margin-left: calc(1rem + var(--sw-space-2));
  }
  @media (pointer: coarse), (width < 40rem) {
    .note {
      margin-left: calc(1.5rem + var(--sw-space-2)); /* below what its box says */
    }
  }
  table {
    width: 100%;
    border-collapse: collapse;
    font-size: var(--sw-text);
  }
  caption {
    padding: var(--sw-space-4) var(--sw-space-4) var(--sw-space-2);
    font-size: var(--sw-text);
    font-weight: 600;
    text-align: left;
  }
  th,
  td {
    padding: 0.3rem var(--sw-space-1);
    font-weight: 400;
    line-height: 1.35;
    text-align: left;
    vertical-align: middle;
  }
  tr > :first-child {
    padding-left: var(--sw-space-4);
  }
  tr > :last-child {
    padding-right: var(--sw-space-4);
  }
  thead th {
    color: var(--sw-soft);
  }
  tbody tr {
    border-top: 1px solid color-mix(in srgb, var(--sw-line) 60%, transparent);
  }
  .pieces tr {
    cursor: pointer;
  }
  .pieces th {
    width: 34%;
    font-weight: 600;
    overflow-wrap: break-word;
    hyphens: auto;
  }
  .pieces td:last-child {
    width: 1%;
    padding-block: 1px;
  }
  .pieces td {
    color: var(--sw-soft);
  }
  .pieces tr:focus-visible {
    outline-offset: -2px;
  }
  .pieces tr.selected {
    background: var(--sw-tint);
    box-shadow: inset 3px 0 var(--sw-accent);
  }
  .error {
    display: block;
  }
  .number {
    text-align: right;
    white-space: nowrap;
  }
  .widths {
    margin-bottom: var(--sw-space-4);
  }
  .widths .of {
    display: block;
    color: var(--sw-soft);
    font-size: var(--sw-text);
    font-weight: 400;
  }
  .widths .present > * {
    font-weight: 600;
  }
  sw-marker-flaws {
    border-top: 1px solid var(--sw-line);
  }
`;
