/** Worker that reads drawings of other programs and converts them to garments. */
import {readDrawing} from '../../files/read-drawing.js';
import {useOfSvg} from '../../files/svg/read-svg.js';
import {defaultChoices, garmentOf} from '../../files/to-garment.js';
import type {DrawingOptions, DrawnPiece} from '../../model/garment/imported-drawing.js';
import {garmentFile} from '../../model/garment/write-garment.js';
import {serve} from '../worker/serve.js';
import {pieceShape} from './piece-shape.js';
import type {Making, Question, ShownDrawing} from './reading.js';

async function drawingOf(file: File, options: DrawingOptions): Promise<ShownDrawing> {
  const bytes = new Uint8Array(await file.arrayBuffer());
  const drawing = readDrawing(bytes, file.name, options);
  return {drawing, shapes: drawing.pieces.map(pieceShape), first: defaultChoices(drawing)};
}

const sewnOutside = ({cut, ...piece}: DrawnPiece): DrawnPiece =>
  cut ? {...piece, sewn: cut} : piece;

function garmentText({drawing, choices, isOuterSewn}: Making): string {
  const pieces = isOuterSewn ? drawing.pieces.map(sewnOutside) : drawing.pieces;
  return garmentFile(garmentOf({...drawing, pieces}, choices));
}

serve(async (asked) => {
  const question = asked as Question;
  switch (question.kind) {
    case 'use':
      return useOfSvg(await question.file.text());
    case 'drawing':
      return drawingOf(question.file, question.options);
    default:
      return garmentText(question);
  }
});
