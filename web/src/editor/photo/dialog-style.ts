import {css} from 'lit';

/** Styles in addition to `sheetDialog`. */
export const dialogStyle = css`
  dialog {
    width: min(80rem, calc(100vw - 2rem));
  }
  header,
  footer {
    gap: var(--sw-space-2);
    padding: var(--sw-space-3) var(--sw-space-4);
  }
  h2 {
    flex: 1;
    font-size: var(--sw-text-large);
  }
  .doubt {
    flex-basis: 100%;
  }
  .name {
    display: flex;
    flex: 1 1 12rem;
    align-items: center;
    gap: var(--sw-space-2);
  }
  .name input {
    min-width: 0;
    color: var(--sw-ink);
  }
  .intake {
    display: grid;
    gap: var(--sw-space-3);
    padding: var(--sw-space-6) var(--sw-space-4);
  }
  .row {
    display: flex;
    flex-wrap: wrap;
    gap: var(--sw-space-2);
  }
  @media not (pointer: coarse) {
    .camera {
      display: none;
    }
  }
  @media (width < 48rem) {
    dialog {
      width: 100vw;
      height: 100dvh;
      max-height: none;
      margin: 0;
      border: 0;
      border-radius: 0;
    }
    header,
    footer {
      padding: var(--sw-space-2) var(--sw-space-3);
    }
  }
`;
