import {css} from 'lit';

export const paneStyle = css`
  :host {
    display: block;
    position: relative;
    overflow: hidden;
    min-height: 0;
    background: var(--sw-ground);
  }
  .application,
  .stage {
    position: absolute;
    inset: 0;
  }
  .application:focus-visible {
    outline-offset: -2px;
  }
  sw-toolbar {
    position: absolute;
    left: var(--sw-space-3);
    top: var(--sw-space-3);
    right: var(--sw-space-3);
  }
  .foot {
    position: absolute;
    left: var(--sw-space-3);
    right: var(--sw-space-3);
    bottom: var(--sw-space-3);
    display: flex;
    align-items: end;
    justify-content: space-between;
    gap: var(--sw-space-2);
    pointer-events: none;
  }
  .foot > * {
    pointer-events: auto;
  }
  .view {
    display: flex;
    gap: 1px;
    padding: 2px;
    border: 1px solid var(--sw-line);
    border-radius: calc(var(--sw-radius) + 2px);
    background: var(--sw-paper);
  }
  .view button {
    width: 2rem;
    padding: 0;
  }
  .state {
    position: absolute;
    left: 50%;
    bottom: 6.5rem;
    translate: -50% 0;
    width: max-content;
    max-width: calc(100% - 2rem);
    padding: var(--sw-space-1) var(--sw-space-3);
    border: 1px solid var(--sw-line);
    border-radius: 2rem;
    background: var(--sw-paper);
    color: var(--sw-soft);
    pointer-events: none;
  }
`;
