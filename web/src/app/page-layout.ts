import {css} from 'lit';

/** Still read out. */
export const unseen = css`
  position: absolute;
  width: 1px;
  height: 1px;
  overflow: hidden;
  clip-path: inset(50%);
`;

/** Words of a button that give way to its icon where there is no room for them. */
export const labelled = css`
  @container (width < 64rem) {
    .outlined:has(> .label) {
      min-width: var(--sw-target);
      padding: 0;
    }
    .label {
      ${unseen}
    }
  }
`;

/** What the page adds to the editor, whose width decides. */
export const pageLayout = css`
  sw-editor {
    --sw-editor-height: 100dvh;
  }
  h1 {
    margin: 0 var(--sw-space-2) 0 0;
    font-size: var(--sw-text-large);
    font-weight: 650;
    letter-spacing: -0.01em;
  }
  ${labelled}
  /* the garment and its files make a row of their own */
  @container (width < 40rem) {
    h1 {
      ${unseen}
    }
    sw-project-list,
    sw-settings {
      order: -2;
    }
    sw-garment-choice {
      flex: 1 1 9rem;
      min-width: 0;
    }
  }
`;
