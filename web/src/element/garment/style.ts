import {css} from 'lit';

import {progressLine} from '../../editor/style/progress-line.js';

export const garmentStyle = css`
  ${progressLine}
  :host {
    display: block;
    position: relative;
    aspect-ratio: 4 / 3;
    contain: content;
    background: var(--sw-ground);
  }
  :host([hidden]) {
    display: none;
  }
  :host([mode='place' i]) {
    aspect-ratio: auto;
    min-height: 36rem; /* room for the pattern above what is under it */
  }
  :host([mode='edit' i]) {
    aspect-ratio: auto;
    min-height: 20rem;
  }
  .frame {
    display: grid;
    grid-template-rows: auto minmax(0, 1fr) auto;
    height: 100%;
    min-height: inherit;
    container-type: inline-size;
  }
  .stage {
    display: grid;
    grid-template: minmax(0, 1fr) / minmax(0, 1fr);
    position: relative;
    min-height: 0;
  }
  .stage[data-view='both'] {
    grid-template-columns: repeat(2, minmax(0, 1fr));
    grid-auto-rows: minmax(0, 1fr);
  }
  @container (width < 36rem) {
    :host([mode='place' i]) .stage[data-view='both'] {
      grid-template-columns: minmax(0, 1fr); /* one above the other */
    }
  }
  sw-worn {
    container-type: size;
  }
  .stage:focus-visible {
    outline-offset: -2px;
  }
  /* where the editor has no room for columns it is higher than that, and scrolls */
  :host([mode='edit' i]) .stage {
    max-height: var(--sw-editor-height, min(100dvh, 48rem));
    overflow: hidden auto;
  }
  .poster {
    position: absolute;
    inset: 0;
    display: grid;
    place-content: center;
    place-items: center;
    padding: var(--sw-space-4);
    overflow: hidden;
    background: var(--sw-ground);
    color: var(--sw-soft);
    text-align: center;
    text-wrap: balance;
  }
  .poster[hidden] {
    display: none;
  }
  ::slotted([slot='poster']) {
    max-width: 100%;
    max-height: 100%;
  }
  .message {
    position: absolute;
    inset: auto var(--sw-space-3) var(--sw-space-3);
    max-height: 50%;
    overflow: auto;
    padding: var(--sw-space-2) var(--sw-space-3);
    border: 1px solid var(--sw-bad);
    border-radius: var(--sw-radius);
    background: var(--sw-bad-tint);
    overflow-wrap: anywhere;
  }
`;
