/**
 * Tabs of a narrow editor, whose sheets open below the pattern, one at a time. A second press
 * closes a sheet.
 */
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
