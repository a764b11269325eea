/** List of the edges for screen readers, while the sewing tool is active. */
import {html, type TemplateResult} from 'lit';

import type {SewingTool} from '../../workbench/sewing/sewing-tool.js';

export function edgeOptions({activeId, chooser}: SewingTool, label: string): TemplateResult {
  return html`<div role="listbox" class="hidden" id="options" aria-label=${label}>
    ${chooser.options().map(({edge, text}) => {
      const id = `edge-${edge.piece}-${edge.edge}`;
      return html`<div role="option" id=${id} aria-selected=${id === activeId}>${text}</div>`;
    })}
  </div>`;
}
