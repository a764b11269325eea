import {html, nothing, type TemplateResult} from 'lit';

import type {PhotoTexts} from '../../texts/photo-texts.js';
import {pictureButton} from './picture-button.js';

interface Intake {
  readonly words: PhotoTexts;
  /** Problem with the given image. */
  readonly trouble: string | undefined;
  readonly take: (file: File) => void;
}

/** Buttons to choose or take a photo, with advice on taking it. */
export function photoIntake({words, trouble, take}: Intake): TemplateResult {
  return html`<div class="intake">
    <p>${words.intake}</p>
    <p class="soft">${words.stays}</p>
    ${trouble ? html`<p class="error" role="alert">${trouble}</p>` : nothing}
    <div class="row">
      ${pictureButton({label: words.choose, look: 'primary', take})}
      ${pictureButton({label: words.camera, look: 'outlined', isCamera: true, take})}
    </div>
  </div>`;
}
