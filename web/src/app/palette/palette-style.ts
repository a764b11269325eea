import {css} from 'lit';

export const paletteStyle = css`
  dialog {
    width: min(40rem, calc(100vw - 2rem));
    max-width: none;
    max-height: min(34rem, 80dvh);
    margin: 10dvh auto auto;
    padding: 0;
    overflow: hidden;
    border: 1px solid var(--sw-line);
    border-radius: calc(2 * var(--sw-radius));
    background: var(--sw-paper);
    color: var(--sw-ink);
    box-shadow: 0 12px 48px light-dark(rgb(38 40 44 / 0.24), rgb(0 0 0 / 0.6));
  }
  dialog[open] {
    display: flex;
  }
  dialog::backdrop {
    background: rgb(20 21 24 / 0.4);
  }
  .inside {
    flex: 1;
    display: grid;
    grid-template: auto minmax(0, 1fr) auto / minmax(0, 1fr);
    min-height: 0;
  }
  .head {
    display: flex;
    gap: var(--sw-space-2);
    padding: var(--sw-space-3);
    border-bottom: 1px solid var(--sw-line);
  }
  input[role='combobox'] {
    flex: 1;
    min-width: 0;
    min-height: max(2.5rem, var(--sw-target));
    font-size: var(--sw-text-large);
  }
  [role='listbox'] {
    min-height: 0;
    padding: var(--sw-space-2);
    overflow-y: auto;
    overscroll-behavior: contain;
    scrollbar-width: thin;
  }
  [role='listbox']:empty {
    display: none;
  }
  [role='option'] {
    display: flex;
    flex-wrap: wrap;
    align-items: center;
    gap: 0 var(--sw-space-3);
    min-height: var(--sw-target);
    padding: var(--sw-space-1) var(--sw-space-3);
    border-radius: var(--sw-radius);
    cursor: pointer;
    overflow-wrap: anywhere;
  }
  [role='option'] > :first-child {
    flex: 1 1 auto;
  }
  [aria-selected='true'] {
    background: var(--sw-tint);
  }
  [aria-disabled='true'] {
    color: var(--sw-soft);
    cursor: default;
  }
  .why {
    font-size: var(--sw-text);
  }
  kbd {
    padding: 0 var(--sw-space-2);
    border: 1px solid var(--sw-line);
    border-radius: var(--sw-radius);
    background: var(--sw-raised);
    color: var(--sw-soft);
    font: inherit;
    font-size: var(--sw-text);
    white-space: nowrap;
  }
  .none {
    padding: var(--sw-space-4);
  }
  @media (width < 40rem) {
    dialog {
      width: 100vw;
      max-height: 70dvh;
      margin: 0;
      border-width: 0 0 1px;
      border-radius: 0 0 calc(2 * var(--sw-radius)) calc(2 * var(--sw-radius));
    }
  }
`;
