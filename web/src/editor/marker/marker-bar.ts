/** Buttons above and below the fabric layout. */
import {html, nothing, svg, type TemplateResult} from 'lit';

import type {MarkerTexts} from '../../texts/marker-texts.js';
import type {Texts} from '../../texts/texts.js';
import {drawn, icon} from '../style/icons.js';

/** State and functions that the buttons of the fabric layout use. */
interface BarredFabric {
  readonly isReady: boolean;
  /** True if flaws can be marked. */
  readonly canMark: boolean;
  /** The selected piece, if any. */
  readonly chosen: {readonly isPinned: boolean} | undefined;
  readonly hasPins: boolean;
  readonly isMarking: boolean;
  turn(): void;
  togglePin(): void;
  toggleFlawTool(): void;
  pack(): void;
  zoomBy(factor: number): void;
  fit(): void;
}

/** Zoom step of a button; a key zooms less. */
const zoomFactor = 1.4;

const flawIcon = drawn(
  svg`<path d="M2.5 2.5h11v11h-11z" stroke-dasharray="2 2"/><path d="m6 6 4 4M10 6l-4 4"/>`,
);
const packIcon = drawn(svg`<path d="M2.5 7h5v6.5h-5zM9.500 9h4v4.5h-4zM2.500 2.5h11V5h-11z"/>`);

interface Tool {
  readonly label: string;
  readonly picture: TemplateResult;
  readonly key: string;
  readonly isPossible: boolean;
  readonly isOn?: boolean;
  readonly act: () => void;
}

const tool = ({label, picture, key, isPossible, isOn, act}: Tool): TemplateResult =>
  html`<button
    class="tool"
    title="${label} (${key})"
    aria-pressed=${isOn ?? nothing}
    ?disabled=${!isPossible}
    @click=${act}
  >
    ${picture} <span>${label}</span>
  </button>`;

export function markerBar(fabric: BarredFabric, words: MarkerTexts): TemplateResult {
  const {isReady, canMark, chosen, hasPins, isMarking} = fabric;
  const isPossible = isReady && chosen !== undefined;
  const isPinned = chosen?.isPinned ?? false;
  const pack = hasPins ? words.packRest : words.packAgain;
  return html`<div class="bar">
    <div class="group">
      ${tool({
        ...{label: words.turn, picture: icon.quarterTurn, key: 'R', isPossible},
        act: () => {
          fabric.turn();
        },
      })}
      ${tool({
        ...{label: isPinned ? words.unpin : words.pin, picture: icon.pin, key: 'P', isPossible},
        isOn: isPinned,
        act: () => {
          fabric.togglePin();
        },
      })}
      ${tool({
        ...{label: words.flaw, picture: flawIcon, key: 'X', isPossible: canMark, isOn: isMarking},
        act: () => {
          fabric.toggleFlawTool();
        },
      })}
      ${tool({
        ...{label: pack, picture: packIcon, key: 'A', isPossible: isReady},
        act: () => {
          fabric.pack();
        },
      })}
    </div>
  </div>`;
}

export function markerZoom(fabric: BarredFabric, {pattern}: Texts): TemplateResult {
  const part = (label: string, picture: TemplateResult, act: () => void): TemplateResult =>
    html`<button class="icon" aria-label=${label} title=${label} @click=${act}>${picture}</button>`;
  return html`<div class="group" role="group" aria-label=${pattern.view}>
    ${part(pattern.zoomOut, icon.minus, () => {
      fabric.zoomBy(1 / zoomFactor);
    })}
    ${part(pattern.fit, icon.fit, () => {
      fabric.fit();
    })}
    ${part(pattern.zoomIn, icon.plus, () => {
      fabric.zoomBy(zoomFactor);
    })}
  </div>`;
}
