import {css} from 'lit';

import {section} from '../../editor/controls/section.js';

/** Invisible, but available to screen readers. */
export const unseen = css`
  position: absolute;
  width: 1px;
  height: 1px;
  overflow: hidden;
  clip-path: inset(50%);
`;

/** Text of a button, replaced by its icon if there is no room. */
export const labelled = css`
  @container (width < 64rem) {
    .outlined:has(> .label) {
      min-width: var(--sw-target);
      padding: 0;
      border-color: transparent; /* like the icons beside it */
      background: none;
    }
    .label {
      ${unseen}
    }
  }
`;

/** Layout around the editor, depending on the editor's width. */
export const pageLayout = css`
  :host {
    /* long words of narrow panels, by the rules of the page's language */
    hyphens: auto;
    hyphenate-limit-chars: 10 4 4;
  }
  sw-editor {
    --sw-editor-height: 100dvh;
  }
  h1 {
    margin: 0 var(--sw-space-2) 0 0;
    font-size: var(--sw-text-large);
    font-weight: 650;
    letter-spacing: -0.01em;
  }
  .skip {
    position: fixed;
    inset: var(--sw-space-2) auto auto var(--sw-space-2);
    z-index: 3;
  }
  .skip:not(:focus) {
    translate: 0 -200%; /* out of sight, as large as ever */
  }
  .drop {
    position: fixed;
    inset: var(--sw-space-2);
    z-index: 4;
    display: grid;
    place-content: center;
    border: 3px dashed var(--sw-accent);
    border-radius: calc(2 * var(--sw-radius));
    background: color-mix(in srgb, var(--sw-tint) 85%, transparent);
    color: var(--sw-accent);
    font-size: var(--sw-text-title);
    font-weight: 600;
    pointer-events: none; /* the page takes the file */
  }
  .drop[hidden] {
    display: none;
  }
  ${section}
  .tagline {
    display: flex;
    flex: 100 1 0; /* before the gap beside it */
    flex-wrap: wrap; /* on a hidden second line where there is no room for the whole sentence */
    height: 1.5em;
    overflow: hidden;
    color: var(--sw-soft);
    line-height: 1.5;
    white-space: nowrap;
  }
  .tagline::before {
    content: '';
    width: 1px;
    height: 1.5em;
  }
  ${labelled}
  @container (width < 78rem) {
    .tagline {
      ${unseen}
    }
  }
`;
