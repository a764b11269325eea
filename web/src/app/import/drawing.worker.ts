/** Worker that reads drawings of other programs and converts them to garments. */
import {drawingOfPages, openedDrawing} from '../../files/read-drawing.js';
import {useOfSvg} from '../../files/svg/read-svg.js';
import {defaultChoices, garmentOf} from '../../files/to-garment.js';
import type {Drawing, DrawingOptions, DrawnPiece} from '../../model/garment/imported-drawing.js';
import {garmentFile} from '../../model/garment/write-garment.js';
import {serve} from '../worker/serve.js';
import {pieceShape} from './piece-shape.js';
import type {Making, PagesRead, Question, ShownDrawing} from './reading.js';

const shownOf = (drawing: Drawing): ShownDrawing => ({
  drawing,
  shapes: drawing.pieces.map(pieceShape),
  first: defaultChoices(drawing),
});

async function drawingOf(
  file: File,
  options: DrawingOptions,
  onPage: (progress: PagesRead) => Promise<unknown>,
): Promise<ShownDrawing> {
  const bytes = new Uint8Array(await file.arrayBuffer());
  const {drawing, opened} = await openedDrawing(bytes, file.name, options, async (read, count) => {
    await onPage({read, count});
  });
  return {...shownOf(drawing), ...(opened && {opened})};
}

const sewnOutside = ({cut, ...piece}: DrawnPiece): DrawnPiece =>
  cut ? {...piece, sewn: cut} : piece;

function garmentText({drawing, choices, isOuterSewn}: Making): string {
  const pieces = isOuterSewn ? drawing.pieces.map(sewnOutside) : drawing.pieces;
  return garmentFile(garmentOf({...drawing, pieces}, choices));
}

serve(async (asked, request) => {
  const question = asked as Question;
  switch (question.kind) {
    case 'use':
      return useOfSvg(await question.file.text());
    case 'drawing':
      return drawingOf(question.file, question.options, request);
    case 'pages':
      return shownOf(await drawingOfPages(question.opened, question.name, question.options));
    default:
      return garmentText(question);
  }
});
