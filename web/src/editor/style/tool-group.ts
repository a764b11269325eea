/** Groups of buttons, in a frame over their view. */
import {css} from 'lit';

/** Frame with the background colour of paper. */
export const framed = css`
  padding: 2px;
  border: 1px solid var(--sw-line);
  border-radius: calc(var(--sw-radius) + 2px);
  background: var(--sw-paper);
`;

export const toolGroup = css`
  .group {
    display: flex;
    flex-wrap: wrap;
    align-items: center;
    gap: 2px;
    ${framed}
  }
  .group button {
    flex: none;
    padding: 0 var(--sw-space-2);
  }
  .group .icon {
    width: var(--sw-target);
    padding: 0;
  }
`;

/** Tools without text, if there is room for icons only. */
export const wordlessTools = css`
  .group .tool {
    width: var(--sw-target);
    padding: 0;
  }
  .tool span {
    position: absolute;
    width: 1px;
    height: 1px;
    overflow: hidden;
    clip-path: inset(50%);
  }
`;
