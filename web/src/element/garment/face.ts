/** Template of the element. */
import {css, html, nothing, type TemplateResult} from 'lit';

import type {Texts} from '../../texts/texts.js';
import type {Workbench} from '../../workbench/workbench.js';
import type {AttributeElement} from './attribute-element.js';
import type {GarmentMode, GarmentView} from './attributes.js';
import type {OfferedPrint} from './sources.js';
import type {GarmentSession} from './session.js';
import {progressLine} from '../../editor/style/progress-line.js';

export const garmentStyle = css`
  ${progressLine}
  :host {
    display: block;
    position: relative;
    aspect-ratio: 4 / 3;
    contain: content;
    background: var(--sw-ground);
  }
  :host([hidden]) {
    display: none;
  }
  :host([mode='place' i]) {
    aspect-ratio: auto;
    min-height: 36rem; /* room for the pattern above what is under it */
  }
  :host([mode='edit' i]) {
    aspect-ratio: auto;
    min-height: 20rem;
  }
  .frame {
    display: grid;
    grid-template-rows: auto minmax(0, 1fr) auto;
    height: 100%;
    min-height: inherit;
    container-type: inline-size;
  }
  .stage {
    display: grid;
    grid-template: minmax(0, 1fr) / minmax(0, 1fr);
    position: relative;
    min-height: 0;
  }
  .stage[data-view='both'] {
    grid-template-columns: repeat(2, minmax(0, 1fr));
    grid-auto-rows: minmax(0, 1fr);
  }
  @container (width < 36rem) {
    :host([mode='place' i]) .stage[data-view='both'] {
      grid-template-columns: minmax(0, 1fr); /* one above the other */
    }
  }
  sw-drape-pane {
    container-type: size;
  }
  .stage:focus-visible {
    outline-offset: -2px;
  }
  /* where the editor has no room for columns it is higher than that, and scrolls */
  :host([mode='edit' i]) .stage {
    max-height: var(--sw-editor-height, min(100dvh, 48rem));
    overflow: hidden auto;
  }
  .poster {
    position: absolute;
    inset: 0;
    display: grid;
    place-content: center;
    place-items: center;
    padding: var(--sw-space-4);
    overflow: hidden;
    background: var(--sw-ground);
    color: var(--sw-soft);
    text-align: center;
    text-wrap: balance;
  }
  .poster[hidden] {
    display: none;
  }
  ::slotted([slot='poster']) {
    max-width: 100%;
    max-height: 100%;
  }
  .message {
    position: absolute;
    inset: auto var(--sw-space-3) var(--sw-space-3);
    max-height: 50%;
    overflow: auto;
    padding: var(--sw-space-2) var(--sw-space-3);
    border: 1px solid var(--sw-bad);
    border-radius: var(--sw-radius);
    background: var(--sw-bad-tint);
    overflow-wrap: anywhere;
  }
`;

/** Display settings of a drape. */
type Worn = Pick<AttributeElement, 'dummy' | 'camera' | 'turntable'>;

interface Face {
  readonly session: GarmentSession;
  readonly texts: Texts;
  /** The loaded part of the mode. */
  readonly mode: GarmentMode;
  readonly view: GarmentView;
  readonly worn: Worn;
  readonly alt: string;
  readonly isDisabled: boolean;
  readonly isDrawn: boolean;
  /** No drawing code is loaded before the start. */
  readonly hasBegun: boolean;
  /** A form may move the focus to it. */
  readonly isMissing: boolean;
  readonly prints: readonly OfferedPrint[];
  readonly choose: (print: OfferedPrint) => void;
}

export function faceOf(face: Face): TemplateResult {
  const {session, mode, texts, isDrawn} = face;
  const view = viewOf(face);
  const {state, error, workbench} = session;
  const hidesDrawing = !isDrawn || (state === 'error' && mode === 'preview');
  const isBusy = state === 'loading' || state === 'solving';
  // the editor itself shows errors that its user can correct
  const says = error && !(mode === 'edit' && workbench.solving.state.kind === 'failed');
  return html`<div class="frame" ?inert=${face.isDisabled}>
      <div part="toolbar"><slot name="toolbar"></slot></div>
      <div class="stage" data-view=${view} part="stage" tabindex=${face.isMissing ? -1 : nothing}>
        ${face.hasBegun ? stage({...face, view}, workbench) : nothing}
        <div class="poster" part="poster" ?hidden=${!hidesDrawing || mode === 'edit'}>
          <slot name="poster"><p>${face.alt || texts.garment.label}</p></slot>
        </div>
        <progress
          part="progress"
          aria-hidden="true"
          ?hidden=${!isBusy || mode === 'edit'}
          max="1"
          .value=${workbench.solving.state.kind === 'solving' ? workbench.running.progress.fraction : 0}
        ></progress>
      </div>
      ${mode === 'place' ? panel(face) : nothing}
    </div>
    ${says ? html`<p class="message" part="message" role="alert">${error.message}</p>` : nothing}`;
}

/** Placing a print needs the flat pieces, so they are shown as well. */
const viewOf = ({mode, view}: Face): GarmentView =>
  mode === 'place' && view === 'garment' ? 'both' : view;

function stage({mode, view, worn}: Face, workbench: Workbench): TemplateResult {
  if (mode === 'edit') return html`<sw-editor .workbench=${workbench} .shows=${view}></sw-editor>`;
  const flat =
    mode === 'place'
      ? html`<sw-pattern .workbench=${workbench} .purpose=${'place'}></sw-pattern>`
      : html`<sw-drawing .workbench=${workbench}></sw-drawing>`;
  return html`${view === 'garment' ? nothing : flat}
  ${view === 'pattern' ? nothing : wornGarment(worn, view === 'both', workbench)}`;
}

/** @param beside true if the pattern is shown, too */
const wornGarment = (worn: Worn, beside: boolean, workbench: Workbench): TemplateResult =>
  html`<sw-drape-pane
    .workbench=${workbench}
    .beside=${beside}
    .purpose=${'show'}
    .form=${worn.dummy}
    .camera=${worn.camera}
    .turntable=${worn.turntable}
  ></sw-drape-pane>`;

const panel = ({session: {workbench}, prints, choose}: Face): TemplateResult =>
  html`<sw-place-bar
    part="panel"
    .workbench=${workbench}
    .prints=${prints}
    .chosen=${workbench.history.design?.print.file?.place?.url ?? ''}
    @sw-print=${({detail}: CustomEvent<OfferedPrint>) => {
      choose(detail);
    }}
  ></sw-place-bar>`;
