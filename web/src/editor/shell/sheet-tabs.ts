/** What opens below the pattern where there is no room beside it, one sheet at a time; another press closes it. */
import {html, type TemplateResult} from 'lit';

import type {Texts} from '../../texts/texts.js';

export type Sheet = 'print' | 'cutting' | 'fit' | 'lists';

export function sheetTabs(
  {app, print, controls, headline, lists}: Texts,
  open: Sheet | undefined,
  show: (sheet: Sheet | undefined) => void,
): TemplateResult {
  const names: readonly (readonly [Sheet, string])[] = [
    ['print', print.title],
    ['cutting', controls.fit],
    ['fit', headline.fit],
    ['lists', lists.pieces],
  ];
  return html`<nav class="tabs" aria-label=${app.panels}>
    ${names.map(
      ([name, label]) =>
        html`<button
          aria-expanded=${open === name}
          @click=${() => {
            show(open === name ? undefined : name);
          }}
        >
          ${label}
        </button>`,
    )}
  </nav>`;
}
