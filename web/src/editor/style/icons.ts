/** Line icons in the colour of the text beside them. */
import {svg, html, type TemplateResult} from 'lit';

/** Returns an icon of 16 by 16 units, drawn with lines. */
export const drawn = (paths: TemplateResult): TemplateResult =>
  html`<svg
    viewBox="0 0 16 16"
    width="16"
    height="16"
    fill="none"
    stroke="currentColor"
    stroke-width="1.5"
    stroke-linecap="round"
    stroke-linejoin="round"
    aria-hidden="true"
  >
    ${paths}
  </svg>`;

export const icon = {
  pattern: drawn(svg`<path d="M2.5 13V6.5L5 3h1v10zM13.5 13V6.5L11 3h-1v10z"/>`),
  sew: drawn(
    svg`<path d="M13.5 2.5 5 11M13.5 2.5l-1.2 2.6L10.9 3.7zM5 11l-.8.8"/><path d="M4 12c-2 .5-2-2 0-2.500s3-3 .5-4" stroke-dasharray="2 2"/>`,
  ),
  fold: drawn(svg`<path d="M2 13V3h4l4 3v7l-4-3H2M10 6l-4 4V3M10 13h4V3H8.500"/>`),
  garment: drawn(svg`<path d="M6 2.5 4 3.5 5 8l-2 5.5h10L11 8l1-4.5-2-1C9.5 4 6.5 4 6 2.5z"/>`),
  both: drawn(svg`<path d="M2 3h12v10H2zM8 3v10"/>`),
  turntable: drawn(
    svg`<ellipse cx="8" cy="10.5" rx="5.5" ry="2.5"/><path d="M8 8V2.5M6 4.5l2-2 2 2"/>`,
  ),
  plus: drawn(svg`<path d="M8 3.5v9M3.5 8h9"/>`),
  minus: drawn(svg`<path d="M3.5 8h9"/>`),
  fit: drawn(svg`<path d="M3 6V3h3M10 3h3v3M13 10v3h-3M6 13H3v-3"/>`),
  pencil: drawn(svg`<path d="m3 13 .7-3L10.5 3.2l2.3 2.3L6 12.3zM9.2 4.5l2.3 2.3"/>`),
  quarterTurn: drawn(
    svg`<path d="M3 13.5V8h5.5v5.5zM5.5 5.5A4.5 4.5 0 0 1 10 2.5M8 .8l2.2 1.7L8.6 4.6"/><path d="M10.5 8h3v5.5h-3" stroke-dasharray="1.5 2"/>`,
  ),
  undo: drawn(svg`<path d="M5.5 3 2.5 6l3 3M2.5 6H10a3.5 3.5 0 0 1 0 7H7"/>`),
  redo: drawn(svg`<path d="m10.5 3 3 3-3 3M13.5 6H6a3.5 3.5 0 0 0 0 7h3"/>`),
  open: drawn(svg`<path d="M2 12.5v-9h4l1.5 2H14v7z"/>`),
  save: drawn(svg`<path d="M8 2.5v8M4.5 7.5 8 11l3.5-3.5M2.5 13.5h11"/>`),
  cut: drawn(
    svg`<circle cx="4" cy="12" r="2"/><circle cx="12" cy="12" r="2"/><path d="M5.2 10.4 11 2.5M10.8 10.4 5 2.5"/>`,
  ),
  projects: drawn(
    svg`<path d="M2.5 2.5H7V7H2.5zM9 2.5h4.5V7H9zM2.5 9H7v4.5H2.5zM9 9h4.5v4.5H9z"/>`,
  ),
  copy: drawn(svg`<path d="M5.5 5.5h8v8h-8zM10.5 5.5v-3h-8v8h3"/>`),
  bin: drawn(svg`<path d="M3 4.5h10M6 4.5v-2h4v2M4.5 4.5l.5 9h6l.5-9M7 7v4M9 7v4"/>`),
  search: drawn(svg`<circle cx="7" cy="7" r="4.5"/><path d="m10.5 10.5 3.5 3.5"/>`),
  link: drawn(
    svg`<path d="M6.5 9.5 9.5 6.5M7 4.5 8.5 3a3 3 0 0 1 4.5 4.5L11.5 9M9 11.5 7.5 13A3 3 0 0 1 3 8.5L4.5 7"/>`,
  ),
  project: drawn(svg`<path d="M3 2.5h8l2.5 2.5v8.5H3zM5.5 2.5v3.5h4V2.5M5.5 13.5V9.5h5v4"/>`),
  result: drawn(svg`<path d="M4 2.5h5.5L12.5 5.5v8H4zM6 9.5l1.5 1.5 3-3.5"/>`),
  close: drawn(svg`<path d="m4 4 8 8M12 4l-8 8"/>`),
  settings: drawn(
    svg`<path d="M2.5 5h6M11.5 5h2M2.5 11h2M7.5 11h6"/><circle cx="10" cy="5" r="1.5"/><circle cx="6" cy="11" r="1.5"/>`,
  ),
  continuous: drawn(svg`<path d="M3 6h10M3 10h10"/>`),
  mirrored: drawn(svg`<path d="M8 2.5v11M5.5 5 2.5 8l3 3M10.5 5l3 3-3 3"/>`),
  piece: drawn(svg`<path d="M8 2v12" stroke-dasharray="2 2"/><path d="M5.5 4 3 13h10L10.5 4z"/>`),
  pair: drawn(
    svg`<path d="M8 2v12" stroke-dasharray="2 2"/><path d="m5.5 4-3.5 4 3.5 4zM10.5 4l3.5 4-3.5 4z"/>`,
  ),
  move: drawn(svg`<path d="M8 2v12M2 8h12M6 4l2-2 2 2M6 12l2 2 2-2M4 6 2 8l2 2M12 6l2 2-2 2"/>`),
  movement: drawn(
    svg`<path d="M3 13 13 3M8.5 3H13v4.5"/><path d="M3 3v4M3 3h4" stroke-dasharray="1 2.5"/>`,
  ),
  cloth: drawn(svg`<path d="M3 3.5c2-1 3.5 1 5 0s3-1 5 0v9c-2-1-3.5-1-5 0s-3 1-5 0z"/>`),
  before: drawn(
    svg`<path d="M5.5 3.500A5.500 5.500 0 1 1 2.6 7.2M2.500 3v4.200h4.200M8 5v3.300l2.200 1.300"/>`,
  ),
  wipe: drawn(svg`<path d="M8 2v12M2.5 4.5h3M2.5 8h3M2.5 11.5h3"/><path d="M10.5 4.5h3v7h-3"/>`),
  locked: drawn(svg`<path d="M4 7.5h8v6H4zM5.5 7.5V5a2.5 2.5 0 0 1 5 0v2.5"/>`),
  unlocked: drawn(svg`<path d="M4 7.5h8v6H4zM5.5 7.5V5A2.5 2.5 0 0 1 10 3.6"/>`),
  measure: drawn(svg`<path d="M2 10.5 10.5 2 14 5.5 5.5 14zM5 7.5 6.5 9M7.5 5 9 6.5"/>`),
  up: drawn(svg`<path d="M8 13V3.5M4 7.5l4-4 4 4"/>`),
  down: drawn(svg`<path d="M8 3v9.5M4 8.5l4 4 4-4"/>`),
  pin: drawn(svg`<path d="M5.5 2.5h5M6.5 2.5v4.5L4 9.5h8L9.5 7V2.5M8 9.5V14"/>`),
  more: drawn(svg`<path d="M3.5 8h.01M8 8h.01M12.5 8h.01" stroke-width="2.2"/>`),
  lock: drawn(svg`<path d="M3.5 7.5h9v6h-9zM5.5 7.5V5a2.5 2.5 0 0 1 5 0v2.5"/>`),
  widen: drawn(svg`<path d="M2 8h12M4.5 5.5 2 8l2.5 2.5M11.5 5.5 14 8l-2.5 2.5"/>`),
};
