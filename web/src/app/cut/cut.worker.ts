/** Worker that lays out pieces and writes cutting sheets. */
import {cutSheet} from '../../cutting/lay-sheet.js';
import type {CutSheet} from '../../cutting/cut-sheet.js';
import {onPiece, type Alignment} from '../../model/geometry/vectors.js';
import {asCut} from '../../model/print/as-cut.js';
import {cutFile} from '../../paper/cut-file.js';
import {guideCount} from '../../paper/guide-pages.js';
import {pagesOf} from '../../paper/cutting-pdf.js';
import {paperOf} from '../../paper/papers.js';
import {drawnLetters} from '../../workbench/cutting/drawn-letters.js';
import {serve} from '../worker/serve.js';
import type {CutPlan, Question} from './cut-job.js';

/** The alignment on the print of a piece that was moved to another place. */
const after = (place: Alignment, {angle, translation}: Alignment): Alignment => ({
  angle: place.angle + angle,
  translation: onPiece(place, translation),
});

function planOf(sheet: CutSheet, {choices: {file, paper: name, guide}}: Question): CutPlan {
  const {widthCm, heightCm, pieces, ownAllowances} = sheet;
  const paper = file === 'pdf' ? paperOf(name) : undefined;
  const plan = {
    ...{widthCm, heightCm, ownAllowances},
    pieces: pieces.map(({cut, place, alignment}) => ({
      cut,
      ...(alignment && {alignment: after(place, alignment)}),
    })),
  };
  if (!paper) return plan;
  const layout = pagesOf(sheet, paper);
  const {pages, widthCm: across, heightCm: up} = layout;
  const boxes = pages.map(({window, name}) => ({...window, ...(name !== undefined && {name})}));
  const guides = guide && !paper.isProjector ? guideCount(layout, sheet.pieces) : 0;
  return {...plan, pages: {widthCm: across, heightCm: up, boxes, guides}};
}

serve(async (asked, request) => {
  const question = asked as Question;
  const {kind, result, print, marks, options, choices} = question;
  const sheet = cutSheet(result, print, marks, options);
  if (kind === 'plan') return planOf(sheet, question);
  const pixels = async (width: number, height: number) =>
    (await request({width, height})) as Uint8Array<ArrayBuffer> | undefined;
  const {file, paper, ink, guide, dxfStyle: style, dxfUnit: unit} = choices;
  return cutFile(sheet, asCut(print), {
    ...{file, paper, ink, dxf: {style, unit}, pixels, letters: drawnLetters},
    ...(guide && {guide: options}),
  });
});
