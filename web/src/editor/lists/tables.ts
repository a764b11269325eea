/** Everything about the garment as text: its pieces, then its seams. */
import {html, type TemplateResult} from 'lit';

import {WorkbenchElement} from '../base/workbench-element.js';

export class Tables extends WorkbenchElement {
  protected override render(): TemplateResult {
    return html`<sw-piece-table .workbench=${this.workbench}></sw-piece-table
      ><sw-seam-table .workbench=${this.workbench}></sw-seam-table>`;
  }
}
