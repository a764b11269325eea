/** Pictures of a good photo of fabric and of a bad one. */
import {css, html, svg, type TemplateResult} from 'lit';

import type {PhotoTexts} from '../../texts/photo-texts.js';

export const adviceStyle = css`
  .advice {
    display: grid;
    grid-template-columns: repeat(2, minmax(0, 1fr));
    gap: var(--sw-space-4);
    max-width: 36rem;
  }
  .advice figure {
    display: grid;
    gap: var(--sw-space-2);
    align-content: start;
    margin: 0;
  }
  .advice svg {
    display: block;
    width: 100%;
    border-radius: var(--sw-radius);
  }
  .advice figcaption {
    display: grid;
    grid-template-columns: auto 1fr;
    gap: var(--sw-space-2);
    color: var(--sw-soft);
    line-height: 1.3;
  }
  .advice figcaption::before {
    content: '✓';
    color: #2e7d4f;
    font-weight: 700;
  }
  .advice .bad figcaption::before {
    content: '✗';
    color: #c22318;
  }
`;

/** A flower on light fabric. `side` is its repeat in units of the picture. */
const flowers = (id: string, side: number, turn: string): TemplateResult =>
  svg`<pattern id=${id} width="20" height="20" patternUnits="userSpaceOnUse"
    patternTransform="${turn} scale(${side / 20})">
    <rect width="20" height="20" fill="#f1e7d6"></rect>
    <path d="M10 11V19" stroke="#5d7f5b" stroke-width="1.5"></path>
    <circle cx="7" cy="6" r="3" fill="#c25b5b"></circle>
    <circle cx="13" cy="6" r="3" fill="#c25b5b"></circle>
    <circle cx="7" cy="11" r="3" fill="#c25b5b"></circle>
    <circle cx="13" cy="11" r="3" fill="#c25b5b"></circle>
    <circle cx="10" cy="8.5" r="2" fill="#e7b65a"></circle>
  </pattern>`;

const good = svg`<svg viewBox="0 0 160 110" aria-hidden="true">
  <defs>${flowers('flat', 18, 'rotate(2)')}</defs>
  <rect width="160" height="110" fill="url(#flat)"></rect>
  <circle cx="112" cy="74" r="10" fill="#c9a84f" stroke="#8d7433"></circle>
  <circle cx="112" cy="74" r="6.5" fill="#c8c5bd"></circle>
</svg>`;

const bad = svg`<svg viewBox="0 0 160 110" aria-hidden="true">
  <defs>${flowers('tilted', 34, 'matrix(1 0.1 -0.35 0.6 0 0)')}</defs>
  <rect width="160" height="110" fill="#7b6b5c"></rect>
  <path d="M8 104L152 96L120 22Q84 34 46 16Z" fill="url(#tilted)"></path>
  <path d="M62 20Q74 60 60 101M96 28Q84 64 104 99" fill="none" stroke="#000" stroke-opacity="0.3"
    stroke-width="4"></path>
  <path d="M0 0H70L20 110H0Z" fill="#000" fill-opacity="0.4"></path>
</svg>`;

/** Both pictures, with the difference in words. */
export function photoAdvice(words: PhotoTexts): TemplateResult {
  return html`<div class="advice">
    <figure>
      ${good}
      <figcaption>${words.good}</figcaption>
    </figure>
    <figure class="bad">
      ${bad}
      <figcaption>${words.bad}</figcaption>
    </figure>
  </div>`;
}
