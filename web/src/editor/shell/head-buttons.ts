/** Buttons in the header of the editor: views, undo and redo, and start or end of a solve. */
import {html, type TemplateResult} from 'lit';

import type {Texts} from '../../texts/texts.js';
import type {Workbench} from '../../workbench/workbench.js';
import {canAlign} from '../../workbench/can-align.js';
import {icon} from '../style/icons.js';

/**
 * Tabs of a narrow editor, whose sheets open below the pattern, one at a time. A second press
 * closes a sheet.
 */
export type Sheet = 'print' | 'cutting' | 'fit' | 'lists';

export function sheetTabs(
  {app, print, controls, headline, lists}: Texts,
  open: Sheet | undefined,
  show: (sheet: Sheet | undefined) => void,
): TemplateResult {
  const names: readonly (readonly [Sheet, string])[] = [
    ['print', print.title],
    ['cutting', controls.fit],
    ['fit', headline.result],
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

export function viewButtons<View extends keyof Texts['pattern']['views'] & keyof typeof icon>(
  views: readonly View[],
  shown: View,
  {pattern}: Texts,
  show: (view: View) => void,
): TemplateResult {
  const words = pattern.views;
  return html`<div class="views" role="group" aria-label=${words.label}>
    ${views.map(
      (view) =>
        html`<button
          title=${words[view]}
          aria-pressed=${view === shown}
          @click=${() => {
            show(view);
          }}
        >
          ${icon[view]}<span>${words[view]}</span>
        </button>`,
    )}
  </div>`;
}

interface Step {
  /** Name of the step; undefined if there is no step. */
  readonly words: string | undefined;
  readonly run: () => void;
}

export function stepButtons(
  {app}: Texts,
  {undo, redo}: {readonly undo: Step; readonly redo: Step},
): TemplateResult {
  return html`${iconButton(app.undo, undo.words && app.undoOf(undo.words), icon.undo, undo.run)}
  ${iconButton(app.redo, redo.words && app.redoOf(redo.words), icon.redo, redo.run)}`;
}

const iconButton = (
  label: string,
  title: string | undefined,
  picture: TemplateResult,
  act: () => void,
): TemplateResult =>
  html`<button
    class="icon"
    aria-label=${label}
    title=${title ?? label}
    ?disabled=${title === undefined}
    @click=${act}
  >
    ${picture}
  </button>`;

/** Button that ends a running solve, or starts one if the solver does not start automatically. */
export function solvingButton(workbench: Workbench, words: Texts['app']): TemplateResult {
  const isSolving = workbench.solving.state.kind === 'solving';
  const aligns = canAlign(workbench);
  return html`<button
    class=${aligns ? 'primary' : 'outlined'}
    ?hidden=${!aligns && !isSolving}
    @click=${({detail}: MouseEvent) => {
      if (detail > 1) return; // second click of a double click
      if (isSolving) workbench.solving.cancel();
      else if (aligns) workbench.solving.align();
    }}
  >
    ${aligns ? words.align : words.cancel}
  </button>`;
}
