import {css} from 'lit';

export const stageStyle = css`
  :host {
    display: grid;
    place-items: center;
    min-width: 0;
    min-height: 0;
  }
  .frame {
    position: relative;
    width: min(100%, calc(var(--stage-height, 70dvh) * var(--shape, 1)));
    overflow: hidden;
    touch-action: none;
    user-select: none;
    -webkit-user-select: none;
  }
  img,
  svg {
    position: absolute;
    inset: 0;
    width: 100%;
    height: 100%;
  }
  .busy svg,
  .busy .handle {
    opacity: 0.5;
  }
  path {
    fill: none;
    vector-effect: non-scaling-stroke;
    stroke-linejoin: round;
  }
  .casing {
    stroke: rgb(255 255 255 / 0.55);
    stroke-width: 3;
  }
  .cells {
    stroke: #143a63;
    stroke-width: 1;
  }
  .dot {
    fill: #143a63;
    stroke: #fff;
    vector-effect: non-scaling-stroke;
  }
  .mirrors {
    stroke: #c22318;
    stroke-width: 1.5;
  }
  .glides {
    stroke: #c22318;
    stroke-width: 1.5;
    stroke-dasharray: 5 4;
  }
  .centre {
    fill: #c22318;
    stroke: #fff;
  }
  .differing {
    fill: rgb(194 35 24 / 0.3);
    stroke: #c22318;
  }
  .broken {
    fill: rgb(122 47 181 / 0.45);
  }
  .outline {
    fill: rgb(194 35 24 / 0.12);
    stroke: #c22318;
    stroke-width: 2;
  }
  .arrow {
    stroke-width: 2.5;
    stroke-linecap: round;
  }
  .arrow.casing {
    stroke: #fff;
    stroke-width: 5;
  }
  .arrow.w1,
  .arrow.w2 {
    stroke: #0b5fb3;
  }
  .arrow.measured {
    stroke: #c22318;
    stroke-width: 5;
  }
  text {
    fill: #0b5fb3;
    stroke: #fff;
    stroke-width: 4px;
    paint-order: stroke;
    vector-effect: non-scaling-stroke;
    font-weight: 700;
    text-anchor: middle;
    dominant-baseline: central;
  }
  text.measured {
    fill: #c22318;
  }
  .ruler {
    stroke: #c22318;
    stroke-width: 2;
  }
  .handle[data-handle^='node']::before {
    border-color: #0b5fb3;
  }
  .aiming {
    cursor: crosshair;
  }
`;
