import {css} from 'lit';

export const projectListStyle = css`
  dialog {
    display: grid;
    grid-template-rows: auto minmax(0, 1fr);
    width: min(60rem, calc(100vw - 2rem));
    max-width: none;
    max-height: calc(100dvh - 2rem);
    padding: 0;
    border: 1px solid var(--sw-line);
    border-radius: calc(2 * var(--sw-radius));
    background: var(--sw-paper);
    color: var(--sw-ink);
    box-shadow: 0 12px 48px light-dark(rgb(38 40 44 / 0.24), rgb(0 0 0 / 0.6));
  }
  dialog:not([open]) {
    display: none;
  }
  dialog::backdrop {
    background: rgb(20 21 24 / 0.4);
  }
  header {
    display: flex;
    align-items: center;
    justify-content: space-between;
    padding: var(--sw-space-3) var(--sw-space-3) var(--sw-space-3) var(--sw-space-4);
    border-bottom: 1px solid var(--sw-line);
  }
  h2 {
    font-size: var(--sw-text-large);
  }
  .icon {
    flex: none;
  }
  .body {
    padding: var(--sw-space-4);
    overflow-y: auto;
  }
  .note {
    max-width: 60ch;
    margin-bottom: var(--sw-space-4);
  }
  ul {
    display: grid;
    grid-template-columns: repeat(auto-fill, minmax(13.5rem, 1fr));
    gap: var(--sw-space-4);
    margin: 0;
    padding: 0;
    list-style: none;
  }
  li {
    display: grid;
    grid-template-rows: minmax(0, 1fr) auto auto;
    min-width: 0;
    overflow: clip;
    overflow-clip-margin: 4px;
    border: 1px solid var(--sw-line);
    border-radius: var(--sw-radius);
    background: var(--sw-raised);
  }
  li.here {
    border-color: var(--sw-accent);
    outline: 1px solid var(--sw-accent);
  }
  .open {
    display: block;
    aspect-ratio: 3 / 2;
    padding: var(--sw-space-2);
    border: 0;
    border-radius: var(--sw-radius) var(--sw-radius) 0 0;
    background: var(--sw-paper);
    color: var(--sw-soft);
  }
  .open > svg {
    width: 2.5rem;
    height: 2.5rem;
    opacity: 0.5;
  }
  .open:focus-visible {
    outline-offset: -2px;
  }
  img {
    display: block;
    width: 100%;
    height: 100%;
    object-fit: contain;
  }
  input.name {
    min-width: 0;
    margin: var(--sw-space-2) var(--sw-space-2) 0;
    width: auto;
    border-color: transparent;
    background: transparent;
    font-weight: 600;
    text-overflow: ellipsis;
  }
  input.name:hover,
  input.name:focus {
    border-color: var(--sw-line);
  }
  .foot {
    display: flex;
    align-items: center;
    padding: 0 var(--sw-space-1) var(--sw-space-1) var(--sw-space-4);
  }
  .foot .soft {
    flex: 1;
    min-width: 0;
    font-size: var(--sw-text);
  }
  .deleted {
    align-content: center;
    gap: var(--sw-space-2);
    grid-template-rows: auto auto;
    justify-items: center;
    min-height: 8rem;
    padding: var(--sw-space-4);
    border-style: dashed;
    background: transparent;
    text-align: center;
    overflow-wrap: anywhere;
  }
  @media (pointer: coarse) {
    .icon {
      width: 2.75rem;
      min-height: 2.75rem;
    }
    input.name {
      min-height: 2.75rem;
      font-size: var(--sw-text-large);
    }
  }
  @media (max-width: 30rem) {
    dialog {
      width: 100vw;
      max-height: 100dvh;
      margin: auto 0 0;
      border-radius: calc(2 * var(--sw-radius)) calc(2 * var(--sw-radius)) 0 0;
    }
    ul {
      grid-template-columns: repeat(2, minmax(0, 1fr));
      gap: var(--sw-space-3);
    }
    .foot {
      padding-left: var(--sw-space-3);
    }
    input.name {
      margin-inline: var(--sw-space-1);
    }
  }
`;
