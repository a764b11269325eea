/** English texts of a drawn layout. Lengths are passed as text with their unit. */
import type {LayNoteCode} from '../../model/result/lay-note.js';
import {text} from '../base/message.js';

export const plan = {
  title: text('Fabric layout 1 : {scale, number}'),
  length: 'Length',
  proven: 'proven: none is shorter',
  atBest: text('at best {length}'),
  lying: 'of the pieces that lie',
  buy: 'Buy',
  roundedUp: text('rounded up to {step}'),
  use: 'Fabric used',
  ofWidth: text('of a width of {width}'),
  cost: 'The print costs',
  without: text('without it {length}'),
  share: text('{share} %'),
  cloth: text(
    'Fabric {width} wide, selvedges {selvedge}, {gap} between pieces, allowance {allowance}; single layer, face up.',
  ),
  folded: text(
    'Fabric {width} wide, selvedges {selvedge}, {gap} between pieces, allowance {allowance}; folded lengthwise {fold} from the left edge, face to face, shown spread.',
  ),
  print: text(
    '{name}: the ring is on a corner of its repeat, {across} from the left edge, {along} from the start.',
  ),
  plain: 'The print is not regarded: pieces lie anywhere.',
  unplaced: text('Pieces without a place: {pieces}.'),
  pinned: text('Pinned pieces cost {length} more.'),
  start: 'Start of the fabric',
  page: text('page {number, number} of {count, number}'),
  garment: text('{piece}, garment {garment, number}'),
  crosses: 'Crosses of a piece lie on one and the same point of the print',
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
    plainPieces: 'Pieces of plain fabric are not laid on the print: {pieces}.',
    pliesUnlike:
      'This print never comes again along the fabric, so no length makes all plies start alike: lay them one by one.',
    pliesWhole:
      'Each of the {count} plies is a whole number of repeats long, of {length}, so that all start alike.',
    flawsFromCut:
      'Flaws are counted from the cut, where the print is taken to start; say how far from it the print starts if it does not.',
    folded:
      'The fabric is folded {rounded} from its left edge, face to face, and both plies are cut at once.',
    foldKeepsPrint:
      'The print is moved under no piece on folded fabric, since the lower ply shows its mirror image.',
    phaseRange: '{least} to {most}, by where the print starts at the selvedge; measure it.',
    phaseNowhere:
      'At {count} of {all} places where the print may start at the selvedge, not all pieces fit on the fabric.',
  } satisfies Record<LayNoteCode, string> as Record<LayNoteCode, string>,
};

export type PlanTexts = typeof plan;
