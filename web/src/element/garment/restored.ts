/** Converts a stored design to an editable one. */
import {decisionsOf, type Design, type DesignPrint} from '../../model/design/design.js';
import {SolverError} from '../../model/result/failure.js';
import type {StoredDesign} from '../../model/documents/stored-design.js';
import type {FileWords} from './files.js';
import type {Loaded} from './sources.js';

/** @throws {SolverError} `file-changed` if a file differs from the one used for the design */
export function restored({garment, print}: Loaded, stored: StoredDesign, words: FileWords): Design {
  for (const [found, sold] of [
    [garment.file, stored.garment],
    [print.file?.place, stored.print],
  ] as const) {
    if (found?.sha256 !== sold.sha256) {
      throw new SolverError({code: 'file-changed', message: words.fileChanged(sold.url)});
    }
  }
  return {garment, print: changed(print, stored.print), ...decisionsOf(stored)};
}

function changed(print: DesignPrint, stored: StoredDesign['print']): DesignPrint {
  const {
    group = print.group,
    size = print.size,
    turnDeg = print.turnDeg,
    oneWay = print.oneWay,
    cell = print.cell,
  } = stored;
  const isMeasured = print.unscaled && stored.size !== undefined;
  return {...print, group, size, turnDeg, oneWay, cell, ...(isMeasured && {unscaled: false})};
}
