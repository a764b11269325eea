/** A progress bar as thin as a line, at the foot of a view. */
import {css} from 'lit';

export const progressLine = css`
  progress {
    position: absolute;
    inset: auto 0 0;
    appearance: none;
    width: 100%;
    height: 3px;
    border: 0;
    background: transparent;
  }
  progress::-webkit-progress-bar {
    background: transparent;
  }
  progress::-webkit-progress-value {
    background: var(--sw-accent);
  }
  progress::-moz-progress-bar {
    background: var(--sw-accent);
  }
`;
