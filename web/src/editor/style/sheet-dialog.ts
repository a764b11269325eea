/**
 * Styles of the dialogs that open and cut patterns and read photos: header, body, settings, footer.
 */
import {css} from 'lit';

export const sheetDialog = css`
  dialog {
    max-width: none;
    max-height: calc(100dvh - 2rem);
    padding: 0;
    overflow: hidden;
    border: 1px solid var(--sw-line);
    border-radius: calc(2 * var(--sw-radius));
    background: var(--sw-paper);
    color: var(--sw-ink);
    box-shadow: 0 12px 48px light-dark(rgb(38 40 44 / 0.24), rgb(0 0 0 / 0.6));
  }
  dialog[open] {
    display: grid;
    grid-template-rows: auto minmax(0, 1fr) auto;
  }
  dialog::backdrop {
    background: rgb(20 21 24 / 0.4);
  }
  header,
  footer {
    display: flex;
    align-items: center;
    gap: var(--sw-space-3);
    padding: var(--sw-space-3) var(--sw-space-3) var(--sw-space-3) var(--sw-space-4);
  }
  header {
    justify-content: space-between;
    border-bottom: 1px solid var(--sw-line);
  }
  footer {
    flex-wrap: wrap;
    justify-content: end;
    border-top: 1px solid var(--sw-line);
  }
  footer .error {
    flex-basis: 100%;
  }
  .settings select {
    color: var(--sw-ink);
  }
`;
