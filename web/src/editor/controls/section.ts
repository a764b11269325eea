/** Layout of a section in the left column. */
import {css} from 'lit';

export const section = css`
  :host {
    display: block;
  }
  section {
    display: grid;
    gap: var(--sw-space-3);
    padding: var(--sw-space-4);
    border-bottom: 1px solid var(--sw-line);
  }
  header {
    display: flex;
    align-items: center;
    justify-content: space-between;
    gap: var(--sw-space-2);
  }
  h2 {
    font-size: var(--sw-text-large);
  }
  select {
    color: var(--sw-ink);
  }
  .beside {
    margin-left: calc(1rem + var(--sw-space-2));
  }
`;
