import {css} from 'lit';

export const progressStyle = css`
  .note {
    display: grid;
    gap: var(--sw-space-2);
    padding: var(--sw-space-3);
    border-radius: var(--sw-radius);
    background: var(--sw-tint);
  }
  progress {
    width: 100%;
    accent-color: var(--sw-accent);
  }
`;
