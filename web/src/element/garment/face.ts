/** What is seen of the element. */
import {html, nothing, type TemplateResult} from 'lit';

import type {Texts} from '../../texts/texts.js';
import type {Workbench} from '../../workbench/workbench.js';
import type {GarmentMode} from './attributes.js';
import type {OfferedPrint} from './offered-prints.js';
import type {GarmentSession} from './session.js';

export interface Face {
  readonly session: GarmentSession;
  readonly texts: Texts;
  /** What of it is loaded. */
  readonly mode: GarmentMode;
  readonly alt: string;
  readonly isDisabled: boolean;
  readonly isDrawn: boolean;
  /** Before it has, nothing that draws is loaded. */
  readonly hasBegun: boolean;
  /** Its form is going to point at it. */
  readonly isMissing: boolean;
  readonly prints: readonly OfferedPrint[];
  readonly choose: (print: OfferedPrint) => void;
}

export function faceOf(face: Face): TemplateResult {
  const {session, mode, texts, isDrawn} = face;
  const {state, error, desk} = session;
  const hidesDrawing = !isDrawn || (state === 'error' && mode === 'preview');
  const isBusy = state === 'loading' || state === 'solving';
  // the editor says itself what its user can mend
  const says = error && !(mode === 'edit' && desk.state.kind === 'failed');
  return html`<div class="frame" ?inert=${face.isDisabled}>
      <div part="toolbar"><slot name="toolbar"></slot></div>
      <div class="stage" part="stage" tabindex=${face.isMissing ? -1 : nothing}>
        ${face.hasBegun ? stage(mode, desk) : nothing}
        <div class="poster" part="poster" ?hidden=${!hidesDrawing || mode === 'edit'}>
          <slot name="poster"><p>${face.alt || texts.garment.label}</p></slot>
        </div>
        <progress
          part="progress"
          aria-hidden="true"
          ?hidden=${!isBusy || mode === 'edit'}
          max="1"
          .value=${desk.state.kind === 'solving' ? desk.state.fraction : 0}
        ></progress>
      </div>
      ${mode === 'place' ? panel(face) : nothing}
    </div>
    ${says ? html`<p class="message" part="message" role="alert">${error.message}</p>` : nothing}`;
}

function stage(mode: GarmentMode, desk: Workbench): TemplateResult {
  switch (mode) {
    case 'preview':
      return html`<sw-drawing .desk=${desk}></sw-drawing>`;
    case 'place':
      return html`<sw-pattern .desk=${desk} .purpose=${'place'}></sw-pattern>`;
    case 'edit':
      return html`<sw-editor .desk=${desk}></sw-editor>`;
  }
}

const panel = ({session: {desk}, prints, choose}: Face): TemplateResult =>
  html`<sw-place-bar
    part="panel"
    .desk=${desk}
    .prints=${prints}
    .chosen=${desk.design?.print.file?.place?.url ?? ''}
    @sw-print=${({detail}: CustomEvent<OfferedPrint>) => {
      choose(detail);
    }}
  ></sw-place-bar>`;
