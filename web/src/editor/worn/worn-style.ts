import {css} from 'lit';

export const wornStyle = css`
  :host {
    display: grid;
    grid-template: auto minmax(0, 1fr) auto / minmax(0, 1fr);
    position: relative;
    overflow: hidden;
    min-height: 0;
    container-type: size;
    background: var(--sw-ground);
  }
  .application {
    grid-area: 2 / 1;
    position: relative;
  }
  .wipe {
    grid-area: 2 / 1;
    position: relative;
    pointer-events: none;
  }
  .application:focus-visible {
    outline-offset: -2px;
  }
  ::slotted([slot='notice']) {
    grid-area: 2 / 1;
    place-self: start center;
    z-index: 2;
    margin-top: var(--sw-space-2);
  }
  .bar,
  .foot {
    z-index: 1;
    display: flex;
    flex-wrap: wrap;
    align-items: center;
    gap: var(--sw-space-1) var(--sw-space-2);
    padding: var(--sw-space-2) var(--sw-space-3);
  }
  .bar {
    grid-area: 1 / 1;
    margin-right: var(--sw-views-room, 0); /* of what lies over it */
  }
  .foot {
    grid-area: 3 / 1;
    align-items: end;
    justify-content: space-between;
  }
  .foot > .group {
    margin-left: auto;
  }
  .group {
    display: flex;
    flex-wrap: wrap;
    align-items: center;
    gap: 1px;
    padding: 2px;
    border: 1px solid var(--sw-line);
    border-radius: calc(var(--sw-radius) + 2px);
    background: var(--sw-paper);
  }
  .group button {
    padding: 0 var(--sw-space-2);
  }
  .group .icon {
    width: var(--sw-target);
    padding: 0;
  }
  .group select {
    flex: none;
    width: auto;
    min-height: var(--sw-target);
    border-color: transparent;
    background: transparent;
    color: var(--sw-ink);
  }
  .said {
    display: flex;
    flex-wrap: wrap;
    align-items: center;
    gap: 0 var(--sw-space-2);
    min-height: calc(var(--sw-target) + 6px);
    max-width: 100%;
    color: var(--sw-soft);
    font-size: var(--sw-text-small);
  }
  .said .told {
    display: inline-flex;
    flex-wrap: wrap;
    align-items: center;
    gap: 0 var(--sw-space-2);
    padding: 2px var(--sw-space-2);
    border: 1px solid var(--sw-line);
    border-radius: calc(var(--sw-radius) + 2px);
    background: var(--sw-paper);
    font-size: var(--sw-text);
  }
  .said .bad {
    border-color: var(--sw-bad);
    background: var(--sw-bad-tint);
    color: var(--sw-ink);
    white-space: normal;
  }
  .said button {
    min-height: calc(var(--sw-target) - 4px);
  }
  .said .numbers {
    min-width: 9.5em; /* the button beside it stays where it is */
    font-variant-numeric: tabular-nums;
  }
  .hidden {
    position: absolute;
    width: 1px;
    height: 1px;
    overflow: hidden;
    clip-path: inset(50%);
    white-space: nowrap;
  }
  progress {
    position: absolute;
    z-index: 1;
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
  @media (prefers-reduced-motion: reduce) {
    .turntable {
      display: none;
    }
  }
  @container (height < 15rem) {
    .bar {
      display: none; /* where there is hardly room for the garment */
    }
  }
  @container (width < 26rem) {
    .bar,
    .foot {
      padding: var(--sw-space-1) var(--sw-space-2);
    }
    .foot {
      gap: 0 var(--sw-space-2);
    }
    .said {
      min-height: 0;
    }
    .zoom,
    .truth {
      display: none;
    }
  }
`;
