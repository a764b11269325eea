/** Base class of the parts of the photo dialog. */
import {css, html, nothing, type TemplateResult} from 'lit';

import {photoTexts, saidFailure, type PhotoTexts} from '../../texts/photo-texts.js';
import {WorkbenchElement} from '../base/workbench-element.js';
import type {PhotoSession} from '../../workbench/photo/photo-session.js';
import type {PhotoProgress} from '../../model/print/photo-reading.js';

/** Progress of reading a photo, and its outcome if nothing else shows that. */
interface Said {
  readonly words: PhotoTexts;
  readonly cancel: string;
  readonly percent: (share: number) => string;
}

/** Instructions for drawing a lattice, with buttons to end it. */
export function drawnByHand(
  {words, cancel}: Said,
  {align, leave}: {readonly align: () => void; readonly leave: () => void},
): TemplateResult {
  return html`<div class="note" role="status">
    <p>${words.hand}</p>
    <button class="primary" @click=${align}>${words.alignHand}</button>
    <button class="outlined" @click=${leave}>${cancel}</button>
  </div>`;
}

/** Progress bar with the present stage and a button to cancel. */
export function progressNote(
  {stage, fraction}: PhotoProgress,
  {words, cancel, percent}: Said,
  stop: () => void,
): TemplateResult {
  return html`<div class="note" role="status">
    <p>${words.reading(words.stages[stage], percent(fraction))}</p>
    <progress max="1" .value=${fraction} aria-label=${words.stages[stage]}></progress>
    <button class="outlined" @click=${stop}>${cancel}</button>
  </div>`;
}

export function photoProgress(session: PhotoSession, said: Said): TemplateResult | typeof nothing {
  const {state} = session;
  const {words} = said;
  switch (state.kind) {
    case 'reading':
      return progressNote(state, said, () => {
        session.cancel();
      });
    case 'cancelled':
      return html`<div class="note" role="status">
        <p>${words.cancelled}</p>
        <button class="outlined" @click=${() => void session.begin()}>${words.again}</button>
      </div>`;
    case 'failed':
      return html`<p class="error" role="alert">${saidFailure(words, state.failure)}</p>`;
    case 'done':
      return nothing;
  }
}

export const progressStyle = css`
  .note {
    display: grid;
    gap: var(--sw-space-2);
    padding: var(--sw-space-3);
    border-radius: var(--sw-radius);
    background: var(--sw-tint);
  }
  progress {
    width: 100%;
    accent-color: var(--sw-accent);
  }
`;

export abstract class PhotoElement extends WorkbenchElement {
  static override properties = {...WorkbenchElement.properties, session: {attribute: false}};
  declare session: PhotoSession;

  protected get words(): PhotoTexts {
    const {language, messages} = this.workbench.preferences.chosen;
    return photoTexts(language, messages);
  }

  /** Texts of a progress bar with a button to cancel. */
  protected get said(): Said {
    const {words, format, texts} = this;
    return {words, cancel: texts.app.cancel, percent: (share) => format.percent(share)};
  }
}
