/** Base class of the parts of the fabric layout. */
import {markerTexts, type MarkerTexts} from '../../texts/marker-texts.js';
import {letterOf, pieceLabel} from '../../workbench/marker/garment-words.js';
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

  /** Returns the label of a piece. @param garment index of its garment on the fabric */
  protected nameOf(name: string, garment = 0): string {
    const added = garment > 0 ? this.layouts.garments[garment] : undefined;
    if (added) return pieceLabel(added, name, this.texts);
    return (
      this.workbench.sheet.scenes?.now.pieces.find((piece) => piece.name === name)?.label ?? name
    );
  }

  /**
   * Returns the label of a piece on the fabric, with the letter of its garment if there are several,
   * numbered if the marker contains several of it.
   */
  protected readonly labelOf = ({number}: Pick<PieceOnFabric, 'number'>): string => {
    const {sources, garments} = this.layouts;
    const {piece = '', result = 0} = sources[number] ?? {};
    const own = this.nameOf(piece, result);
    const label = garments.length > 1 ? `${letterOf(result)} ${own}` : own;
    const same = sources.flatMap((one, k) =>
      one.piece === piece && one.result === result ? [k] : [],
    );
    return same.length > 1 ? `${label} ${same.indexOf(number) + 1}` : label;
  };
}
