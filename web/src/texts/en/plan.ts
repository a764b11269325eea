/** English texts of a drawn layout. Lengths are passed as text with their unit. */
import type {LayNoteCode} from '../../model/result/lay-note.js';
import {text} from '../base/message.js';

export const plan = {
  title: text('Fabric layout 1 : {scale, number}'),
  length: 'Length',
  proven: 'proven shortest',
  atBest: text('at best {length}'),
  lying: 'of the placed pieces',
  buy: 'Buy',
  roundedUp: text('rounded up to {step}'),
  use: 'Fabric used',
  ofWidth: text('of a width of {width}'),
  cost: 'The print costs',
  without: text('without it {length}'),
  share: text('{share} %'),
  fabric: text(
    'Fabric {width} wide, selvedges {selvedge}, {gap} between pieces, allowance {allowance}; single layer, face up.',
  ),
  folded: text(
    'Fabric {width} wide, selvedges {selvedge}, {gap} between pieces, allowance {allowance}; folded lengthwise {fold} from the left edge, right sides together, shown spread.',
  ),
  print: text(
    '{name}: the ring is on a corner of its repeat, {across} from the left edge, {along} from the start.',
  ),
  plain: 'The print is ignored: pieces may be anywhere.',
  unplaced: text('Pieces without a place: {pieces}.'),
  pinned: text('Pinned pieces cost {length} more.'),
  start: 'Start of the fabric',
  page: text('page {number, number} of {count, number}'),
  garment: text('{piece}, garment {garment, number}'),
  crosses: 'The crosses of a piece are on the same point of the print',
  crossesUnit: text('Each from the left edge × from the start of the fabric [{unit}]'),
  number: 'No.',
  piece: 'Piece',
  cross: text('Cross {number, number}'),
  phases: 'The print may start elsewhere at the left edge',
  phase: 'It starts at',
  widths: 'Other fabric',
  width: 'Width',
  none: '–',
  /** Notes on a layout, by code. */
  notes: {
    plainPieces: 'Pieces of plain fabric are not in the layout: {pieces}.',
    pliesUnlike:
      'This print does not repeat along the fabric, so the layers cannot all start at the same point of the print. Cut them one by one.',
    pliesWhole:
      'Each of the {count} layers is a whole number of repeats ({length}) long, so all start at the same point of the print.',
    flawsFromCut:
      'Flaws are measured from the cut, and the print is assumed to start there. If it starts elsewhere, enter the distance.',
    folded:
      'The fabric is folded {rounded} from its left edge, right sides together, and both layers are cut at once.',
    foldKeepsPrint:
      'On folded fabric the print is not moved under any piece, since the lower layer shows its mirror image.',
    phaseRange:
      '{least} to {most}, depending on where the print starts at the selvedge; measure it.',
    phaseNowhere:
      'At {count} of {all} places where the print may start at the selvedge, not all pieces fit on the fabric.',
  } satisfies Record<LayNoteCode, string> as Record<LayNoteCode, string>,
};

export type PlanTexts = typeof plan;
