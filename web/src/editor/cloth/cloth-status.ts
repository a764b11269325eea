/** How far the laying is, what is wrong, what there is to know of what is selected. */
import {html, nothing, type TemplateResult} from 'lit';

import type {ClothTexts} from '../../texts/cloth-texts.js';
import type {Format} from '../../texts/format.js';
import type {Laying} from '../../workbench/laying.js';

interface Status {
  readonly laying: Laying;
  /** Of a failure. */
  readonly why: string;
  /** What was done to a flaw last, whatever is laid meanwhile. */
  readonly told: string;
  /** What was done last. */
  readonly said: string;
  readonly conflict: string | undefined;
  readonly place: string | undefined;
  /** The print cannot be aligned as it is asked for; the panel says why. */
  readonly unaligned: string | undefined;
  readonly isMarking: boolean;
  readonly isDragging: boolean;
  /** Leads to where the size of the print is said. */
  readonly toSize: () => void;
  readonly words: ClothTexts;
  readonly format: Format;
}

/** What may go well another time; all else is the garment's, or the cloth's. */
const passing: ReadonlySet<string> = new Set(['internal', 'network', 'timeout']);

export function clothStatus(status: Status): TemplateResult {
  const {laying, words, format, why} = status;
  const {state} = laying;
  if (status.isMarking) return html`<p class="told">${words.flawHint}</p>`;
  const act = (label: string, run: () => void): TemplateResult =>
    html`<button class="outlined" @click=${run}>${label}</button>`;
  const again = act(words.again, () => {
    laying.pack();
  });
  if (status.isDragging) return doneWords(status);
  switch (state.kind) {
    case 'waiting':
      return html`<p class="told">
        ${status.unaligned ?? (laying.step ? words.stale : words.waiting)}
      </p>`;
    case 'laying':
      return html`<p class="told">
        <span class="numbers">${words.laying(format.percent(state.fraction))}</span>
        ${act(words.cancel, () => {
          laying.cancel();
        })}
      </p>`;
    case 'cancelled':
      return html`<p class="told">${words.cancelled} ${again}</p>`;
    case 'failed':
      return html`<p class="told bad" role="alert">
        ${why} ${passing.has(state.failure.code) ? again : nothing}
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

/** For who does not see it. */
export function spokenStatus({laying, told, said, conflict, place, words, format}: Status): string {
  const {state} = laying;
  if (told !== '') return told;
  if (state.kind === 'laying') {
    return words.laying(format.percent(Math.floor(state.fraction * 4) / 4));
  }
  if (said !== '') return said;
  return [place, conflict].filter((one) => one !== undefined).join('. ');
}
