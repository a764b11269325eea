/** Base class of the parts of the fabric layout. */
import {markerTexts, type MarkerTexts} from '../../texts/marker-texts.js';
import {layoutsOf, type Layouts} from '../../workbench/marker/layouts.js';
import type {PieceOnFabric} from '../../workbench/marker/marker-work.js';
import {WorkbenchElement} from '../base/workbench-element.js';

export abstract class MarkerElement extends WorkbenchElement {
  protected get layouts(): Layouts {
    return layoutsOf(this.workbench).read;
  }

  protected get words(): MarkerTexts {
    const {language, messages} = this.workbench.preferences.chosen;
    return markerTexts(language, messages);
  }

  /** Returns the label of a piece of the garment. */
  protected nameOf(name: string): string {
    return (
      this.workbench.sheet.scenes?.now.pieces.find((piece) => piece.name === name)?.label ?? name
    );
  }

  /** Returns the label of a piece on the fabric, numbered if the marker contains several of it. */
  protected readonly labelOf = ({name, number}: Pick<PieceOnFabric, 'name' | 'number'>): string => {
    const label = this.nameOf(name);
    const {names} = this.layouts;
    const same = names.flatMap((one, k) => (one === name ? [k] : []));
    return same.length > 1 ? `${label} ${same.indexOf(number) + 1}` : label;
  };
}
