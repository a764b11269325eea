/** Picture of an empty list of projects: a pattern on the first of three sheets. */
import {css, svg, type TemplateResult} from 'lit';

export const noProjectsStyle = css`
  .empty {
    display: grid;
    justify-items: center;
    gap: var(--sw-space-3);
    padding: var(--sw-space-2) 0 var(--sw-space-4);
    text-align: center;
  }
  .empty svg {
    width: min(15rem, 80%);
    height: auto;
    color: var(--sw-soft);
  }
  .empty .note {
    margin: 0;
  }
  .empty .piece {
    fill: var(--sw-tint);
    stroke: var(--sw-accent);
  }
`;

export const noProjects: TemplateResult = svg`<svg viewBox="0 0 240 96" fill="none" aria-hidden="true"
  stroke="currentColor" stroke-width="1.5" stroke-linecap="round" stroke-linejoin="round">
  <rect x="6" y="8" width="68" height="80" rx="6"></rect>
  <path class="piece" d="M25 22h7q8 9 16 0h7l4 14-7 5v37H28V41l-7-5z"></path>
  <path stroke="var(--sw-accent)" stroke-dasharray="2.5 3" d="M40 29v46"></path>
  <g opacity="0.45" stroke-dasharray="4 4">
    <rect x="86" y="8" width="68" height="80" rx="6"></rect>
    <rect x="166" y="8" width="68" height="80" rx="6"></rect>
    <path d="M108 24h24l9 54h-42zM182 26h14v52h-14zM204 26h14v52h-14z"></path>
  </g>
</svg>`;
