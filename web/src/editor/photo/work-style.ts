import {css} from 'lit';

export const workStyle = css`
  :host {
    display: grid;
    grid-template-columns: minmax(0, 1fr) 22rem;
    min-height: 0;
  }
  sw-photo-stage {
    padding: var(--sw-space-3);
    background: var(--sw-ground);
    --stage-height: calc(100dvh - 11rem);
  }
  .side {
    display: grid;
    align-content: start;
    gap: var(--sw-space-3);
    padding: var(--sw-space-4);
    overflow-y: auto;
    border-left: 1px solid var(--sw-line);
  }
  @media (width < 48rem) {
    :host {
      grid-template-columns: minmax(0, 1fr);
      grid-template-rows: auto minmax(0, 1fr);
    }
    sw-photo-stage {
      padding: 0;
      --stage-height: 38dvh;
    }
    .side {
      border-left: 0;
      border-top: 1px solid var(--sw-line);
    }
  }
`;
