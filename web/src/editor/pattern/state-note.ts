/** Notes over the pattern as a whole. */
import {css, html, nothing, type TemplateResult} from 'lit';

import type {Texts} from '../../texts/en.js';
import type {Workbench} from '../../workbench/workbench.js';
import type {SewingTool} from '../../workbench/sewing/sewing-tool.js';

/** List of the edges for screen readers, while the sewing tool is active. */
export function edgeOptions({activeId, chooser}: SewingTool, label: string): TemplateResult {
  return html`<div role="listbox" class="hidden" id="options" aria-label=${label}>
    ${chooser.options().map(({edge, text}) => {
      const id = `edge-${edge.piece}-${edge.edge}`;
      return html`<div role="option" id=${id} aria-selected=${id === activeId}>${text}</div>`;
    })}
  </div>`;
}

export const noteStyle = css`
  .state {
    grid-area: 2 / 1;
    place-self: end center;
    z-index: 1;
    max-width: calc(100% - 2rem);
    margin-bottom: var(--sw-space-2);
    padding: var(--sw-space-1) var(--sw-space-3);
    border: 1px solid var(--sw-line);
    border-radius: 2rem;
    background: var(--sw-paper);
    color: var(--sw-soft);
    pointer-events: none;
  }
  .nothing {
    grid-area: 1 / 1 / -1 / 1;
    place-self: center;
    display: grid;
    gap: var(--sw-space-2);
    max-width: 24rem;
    padding: var(--sw-space-4);
    color: var(--sw-soft);
    text-align: center;
    text-wrap: balance;
  }
  .nothing h2 {
    color: var(--sw-ink);
    font-size: var(--sw-text-title);
    font-weight: 600;
  }
`;

const state = (text: string): TemplateResult => html`<p class="state">${text}</p>`;

/** Returns undefined if there is no problem. */
function trouble(
  {solving: {state, pattern: meshed}}: Workbench,
  {pattern}: Texts,
): string | undefined {
  const {kind} = state;
  if (kind === 'stale') return pattern.stale;
  if (kind === 'failed') return meshed && pattern.failed;
  return meshed?.seams.length === 0 ? pattern.noSeams : undefined;
}

/**
 * @param movement returns the greatest change of an outline as text; undefined while changes are
 * hidden
 */
export function stateNote(
  workbench: Workbench,
  texts: Texts,
  movement: () => string | undefined,
): TemplateResult | typeof nothing {
  const text = trouble(workbench, texts) ?? movement();
  return text === undefined ? nothing : state(text);
}

/** Note while nothing is open. */
export const emptyNote = ({pattern}: Texts): TemplateResult =>
  html`<div class="nothing">
    <h2>${pattern.nothing}</h2>
    <p>${pattern.howToOpen}</p>
  </div>`;

export const undrawableNote = (why: string): TemplateResult => state(why);
