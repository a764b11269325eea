/**
 * Foot of the photo dialog: name, another image, a cell drawn by hand, and the button that makes
 * the print.
 */
import {html, nothing, type TemplateResult} from 'lit';

import type {PhotoTexts} from '../../texts/photo-texts.js';
import {isDoubtful} from '../../photo/photo-step.js';
import type {PhotoSession} from '../../workbench/photo/photo-session.js';
import {pictureButton} from './picture-button.js';

interface PhotoFoot {
  readonly words: PhotoTexts;
  readonly session: PhotoSession;
  /** Problem with making the print. */
  readonly trouble: string | undefined;
  readonly name: string;
  readonly isDrawing: boolean;
  readonly isTaking: boolean;
  readonly rename: (name: string) => void;
  readonly take: (file: File) => void;
  readonly draw: () => void;
  readonly use: () => void;
}

export function photoFoot(foot: PhotoFoot): TemplateResult {
  const {words, trouble, isDrawing} = foot;
  const {step, state} = foot.session.read;
  const isReading = state.kind === 'reading';
  const isReady = step !== undefined && !isDrawing && !isReading;
  const isDoubted = isReady && isDoubtful(step);
  return html`<footer>
    ${trouble && state.kind !== 'failed' ? html`<p class="error" role="alert">${trouble}</p>` : nothing}
    ${isDoubted ? html`<p class="doubt" id="doubt">${words.doubt}</p>` : nothing}
    <label class="name">
      ${words.name}
      <input
        type="text"
        maxlength="80"
        .value=${foot.name}
        @change=${(event: Event) => {
          foot.rename((event.target as HTMLInputElement).value);
        }}
      />
    </label>
    ${pictureButton({label: words.another, look: 'outlined', take: foot.take})}
    <button class="outlined" ?disabled=${isDrawing || isReading} @click=${foot.draw}>
      ${words.byHand}
    </button>
    <button
      class=${isDoubted ? 'outlined' : 'primary'}
      aria-describedby=${isDoubted ? 'doubt' : nothing}
      ?disabled=${!isReady || foot.isTaking}
      @click=${foot.use}
    >
      ${isDoubted ? words.useDoubtful : words.use}
    </button>
  </footer>`;
}
