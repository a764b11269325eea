/** How far the reading of a photograph is, and what came of it where nothing else shows that. */
import {html, nothing, type TemplateResult} from 'lit';

import type {PhotoProgress} from '../../model/photo.js';
import type {PhotoTexts} from '../../texts/photo-texts.js';
import type {PhotoSession} from './photo-session.js';
import {saidFailure} from './said-failure.js';

export interface Said {
  readonly words: PhotoTexts;
  readonly cancel: string;
  readonly percent: (share: number) => string;
}

/** A lattice that somebody draws: what to do, and its end. */
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

/** A bar with what is done, and a button that ends it. */
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
