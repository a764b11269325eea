/** Everything about the garment as text: its pieces, and below them its seams. */
import {html, type TemplateResult} from 'lit';

import {DeskElement} from '../base/desk-element.js';

export class Tables extends DeskElement {
  protected override render(): TemplateResult {
    return html`<sw-piece-table .desk=${this.desk}></sw-piece-table
      ><sw-seam-table .desk=${this.desk}></sw-seam-table>`;
  }
}
