/** Status of the fabric layout: progress, failures and conflicts, place of the selected piece. */
import {html, nothing, type TemplateResult} from 'lit';

import {passingFailures} from '../../model/base/failure.js';
import type {Format} from '../../texts/format.js';
import type {MarkerTexts} from '../../texts/marker-texts.js';
import {titleOfFile} from '../../model/garment/piece-names.js';
import type {Layouts} from '../../workbench/marker/layouts.js';

interface Status {
  readonly layouts: Layouts;
  /** Message of a failure. */
  readonly why: string;
  /** Message of the last change to a flaw; displayed even while the solver lays pieces. */
  readonly told: string;
  /** Message of the last action. */
  readonly said: string;
  readonly conflict: string | undefined;
  readonly place: string | undefined;
  /** Message if the print cannot be aligned; the panel shows the reason. */
  readonly unaligned: string | undefined;
  readonly isMarking: boolean;
  readonly isDragging: boolean;
  /** Opens the field for the size of the print. */
  readonly toSize: () => void;
  readonly words: MarkerTexts;
  readonly format: Format;
}

/** Progress of the layout, or of an added garment that is solved for it. */
function layingWords({layouts: {state}, words, format}: Status, step = 100): string {
  if (state.kind !== 'laying') return '';
  const percent = format.percent(Math.floor(state.fraction * step) / step);
  const {inWork} = state;
  if (!inWork) return words.laying(percent);
  return words.matching(titleOfFile(inWork.name), inWork.number, inWork.count, percent);
}

export function markerStatus(status: Status): TemplateResult {
  const {layouts, words, why} = status;
  const {state} = layouts;
  if (status.isMarking) return html`<p class="told">${words.flawHint}</p>`;
  const act = (label: string, run: () => void): TemplateResult =>
    html`<button class="outlined" @click=${run}>${label}</button>`;
  const again = act(words.again, () => {
    layouts.pack();
  });
  if (status.isDragging) return doneWords(status);
  switch (state.kind) {
    case 'waiting':
      return html`<p class="told">
        ${status.unaligned ?? (layouts.step ? words.stale : words.waiting)}
      </p>`;
    case 'laying':
      return html`<p class="told">
        <span class="numbers">${layingWords(status)}</span>
        ${act(words.cancel, () => {
          layouts.cancel();
        })}
      </p>`;
    case 'cancelled':
      return html`<p class="told">${words.cancelled} ${again}</p>`;
    case 'failed':
      return html`<p class="told bad" role="alert">
        ${why} ${passingFailures.has(state.failure.code) ? again : nothing}
        ${state.failure.code === 'unscaled' ? act(words.toSize, status.toSize) : nothing}
      </p>`;
    case 'done':
      return doneWords(status);
  }
}

function doneWords({told, said, conflict, place, words}: Status): TemplateResult {
  if (told !== '') return html`<p class="told">${told}</p>`;
  if (said !== '') return html`<p class="told">${said}</p>`;
  if (conflict !== undefined) return html`<p class="told bad">${conflict}</p>`;
  return html`<span class="place">${place ?? words.hint}</span>`;
}

/** Status for screen readers. */
export function spokenStatus(status: Status): string {
  const {told, said, conflict, place} = status;
  const {state} = status.layouts;
  if (told !== '') return told;
  if (state.kind === 'laying') {
    return layingWords(status, 4);
  }
  if (said !== '') return said;
  return [place, conflict].filter((one) => one !== undefined).join('. ');
}
