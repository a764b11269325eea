import {css} from 'lit';

/** Styles of both tables: small text, aligned numbers. */
export const listStyle = css`
  :host {
    display: block;
    padding: var(--sw-space-2) var(--sw-space-2) var(--sw-space-4);
  }
  table {
    width: 100%;
    border-collapse: collapse;
    font-size: var(--sw-text);
  }
  caption {
    padding: var(--sw-space-2) var(--sw-space-1);
    font-size: var(--sw-text);
    font-weight: 600;
    text-align: left;
  }
  caption span {
    font-weight: 400;
  }
  th,
  td {
    padding: 0.3rem 2px;
    vertical-align: top;
    text-align: left;
    font-weight: 400;
  }
  .number {
    text-align: right;
    white-space: nowrap;
  }
  thead th {
    padding-block: 0.25rem;
    border-bottom: 1px solid var(--sw-line);
    color: var(--sw-soft);
    line-height: 1.25;
    vertical-align: bottom;
  }
  thead .number {
    white-space: normal;
  }
  thead button {
    position: relative;
    min-height: 1.5rem;
    align-items: end;
    padding: 0;
    border: 0;
    border-radius: 2px;
    font-size: var(--sw-text);
    line-height: inherit;
    text-align: inherit;
    white-space: inherit;
  }
  thead button:hover:not(:disabled) {
    background: none;
    color: var(--sw-ink);
  }
  [aria-sort] button {
    color: var(--sw-ink);
    font-weight: 600;
  }
  [aria-sort] button::after {
    content: '↑' / '';
    position: absolute;
    left: 100%;
    padding-left: 1px;
  }
  [aria-sort='descending'] button::after {
    content: '↓' / '';
  }
  .number[aria-sort] {
    padding-left: 0.8rem; /* for the arrow */
  }
  .number[aria-sort] button::after {
    left: auto;
    right: 100%;
    padding: 0 1px 0 0;
  }
  tbody tr {
    border-bottom: 1px solid color-mix(in srgb, var(--sw-line) 60%, transparent);
    cursor: pointer;
  }
  tbody tr:focus-visible {
    outline-offset: -2px;
  }
  tbody tr.pointed {
    background: color-mix(in srgb, var(--sw-ink) 5%, transparent);
  }
  tbody tr.selected {
    background: var(--sw-tint);
    box-shadow: inset 3px 0 var(--sw-accent);
  }
  tbody th {
    overflow-wrap: break-word;
    line-height: 1.3;
    hyphens: auto;
  }
  .fold .link {
    min-height: var(--sw-target);
    text-decoration: none;
  }
  .fold .link::before {
    content: '▸ ' / '';
  }
  .fold [aria-expanded='true']::before {
    content: '▾ ' / '';
  }
  .line {
    display: flex;
    flex-wrap: wrap;
    column-gap: var(--sw-space-1);
    color: var(--sw-soft);
    white-space: nowrap;
  }
  tr:not(.selected) .measured {
    display: none;
  }
  .kept {
    display: block;
    color: var(--sw-soft);
  }
  .line svg,
  .kept svg,
  .kind svg {
    width: 0.8125rem;
    height: 0.8125rem;
    color: var(--sw-soft);
    vertical-align: -0.15em;
  }
  .grain div {
    display: flex;
  }
  .grain select {
    width: 6.25rem; /* for the usual one of them */
  }
  select {
    min-width: 3.75rem;
    min-height: 1.5rem;
    margin-top: -0.2rem;
    padding: 0 2px;
    font-size: var(--sw-text);
  }
  input.name {
    width: 100%;
    min-height: 1.75rem;
    padding: 0 4px;
  }
  .named .icon,
  .turn {
    min-height: 1.5rem;
    padding: 0;
    border: 0;
    color: var(--sw-soft);
    font-size: var(--sw-text);
    vertical-align: middle;
  }
  .named {
    position: relative;
    display: block;
  }
  .named .icon {
    position: absolute;
    right: 0;
    top: -0.2rem;
    width: 1.5rem;
    padding-block: 0.2rem 0.3rem;
    background: var(--sw-paper) content-box; /* over a long name, not over the line below it */
  }
  .turn {
    padding-inline: 2px;
  }
  @media (pointer: coarse), (width < 40rem) {
    thead button,
    select,
    input.name,
    .named .icon,
    .turn {
      min-width: var(--sw-target);
      min-height: var(--sw-target);
    }
    select,
    input.name {
      font-size: var(--sw-field-text);
    }
    .named .icon {
      top: -0.75rem;
    }
    .named {
      padding-inline-end: var(--sw-target);
    }
  }
  /* seen once the row is looked at; touch has no such moment */
  @media (hover: hover) {
    tr:not(:hover, :focus-within, .selected) .named .icon {
      opacity: 0;
    }
  }
  .bar {
    display: block;
    width: 2.75rem;
    height: 4px;
    margin: 3px 0 0 auto;
    border-radius: 2px;
    background: color-mix(in srgb, var(--sw-ink) 10%, transparent);
  }
  p {
    padding: var(--sw-space-1);
  }
`;
