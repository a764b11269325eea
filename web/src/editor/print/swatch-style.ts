/** Styles of swatches to choose from. */
import {css} from 'lit';

export const swatches = css`
  :host {
    display: grid;
    gap: var(--sw-space-3);
  }
  .groups,
  .more {
    display: grid;
    grid-template-columns: repeat(4, minmax(0, 5.5rem));
    gap: var(--sw-space-2);
  }
  .filters {
    display: flex;
    flex-wrap: wrap;
    gap: var(--sw-space-1);
  }
  .filters button {
    padding: 0 var(--sw-space-2);
    border-radius: var(--sw-target);
    font-size: var(--sw-text-small);
  }
  .colourways {
    display: grid;
    grid-template-columns: repeat(3, minmax(0, 7rem));
    gap: var(--sw-space-2);
  }
  :is(.groups, .more, .colourways) button {
    display: grid;
    grid-template-columns: minmax(0, 1fr); /* a long word gives way, not the picture above it */
    overflow-wrap: anywhere;
    hyphens: auto;
    gap: 2px;
    min-height: 0;
    padding: 0;
    border: 0;
    background: none;
    align-content: start;
    line-height: 1.2;
    white-space: normal;
    font-size: var(--sw-text-small);
    color: var(--sw-soft);
  }
  svg {
    display: block;
    width: 100%;
    border-radius: 4px;
    box-shadow: inset 0 0 0 1px var(--sw-line);
  }
  .colourways svg {
    aspect-ratio: 3 / 2;
  }
  :is([aria-checked='true'], [aria-pressed='true']) svg {
    outline: 2px solid var(--sw-accent);
    outline-offset: 1px;
  }
  :is(.groups, .more, .colourways) :is([aria-checked='true'], [aria-pressed='true']) {
    color: var(--sw-accent);
    font-weight: 600;
  }
  button:focus-visible {
    outline-offset: 4px;
  }
  [aria-disabled='true'] svg {
    filter: grayscale(1);
    opacity: 0.35;
  }
  button[aria-disabled='true'] {
    cursor: help;
  }
  .refusal {
    padding: var(--sw-space-3);
    border-radius: var(--sw-radius);
    background: var(--sw-tint);
  }
  .row {
    display: flex;
    flex-wrap: wrap;
    gap: var(--sw-space-1) var(--sw-space-2);
    margin-top: var(--sw-space-1);
  }
`;
