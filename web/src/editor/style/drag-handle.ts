import {css} from 'lit';

/** A point on an image that pointers and keys move: a ring in an area large enough for a finger. */
export const dragHandle = css`
  .handle {
    position: absolute;
    width: 2.75rem;
    height: 2.75rem;
    min-height: 0;
    margin: -1.375rem;
    padding: 0;
    border-radius: 50%;
    cursor: move;
    touch-action: none;
  }
  .handle::before {
    content: '';
    width: 0.9rem;
    height: 0.9rem;
    border: 2px solid #c22318;
    border-radius: 50%;
    background: rgb(255 255 255 / 0.55);
    box-shadow: 0 0 0 2px #fff;
  }
`;
