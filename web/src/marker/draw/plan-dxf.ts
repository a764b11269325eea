/**
 * Writes a layout as DXF for CAD programs and cutters, one block per piece in its place on the
 * fabric.
 */
import {crosses, drawn, layers} from '../../cutting/out/piece-dxf.js';
import {blockName, namesOf, styleText} from '../../cutting/out/sheet-dxf.js';
import type {DxfFormat} from '../../model/base/dxf-format.js';
import {block, dxfFile, insert, line, polyline, text} from '../../files/dxf/records.js';
import {lineColours} from '../../cutting/line-colours.js';
import type {Point} from '../../model/geometry/vectors.js';
import type {LayPlan} from '../../model/result/marker-plan.js';
import {namesIn, planPieces, type KnownPieces} from './plan-pieces.js';
import {plan as english, type PlanTexts} from '../../texts/en/plan.js';

interface PlanDxfOptions extends KnownPieces, DxfFormat {
  readonly texts?: PlanTexts;
}

/**
 * DXF text in 7-bit ASCII. The fabric's left edge is at x = 0, its start at y = 0.
 */
export function planDxf(
  plan: LayPlan,
  {texts = english, style, unit, ...known}: PlanDxfOptions = {},
): string {
  const format = {...(style && {style}), ...(unit && {unit})};
  const pieces = planPieces(plan, known, namesIn(plan, known, texts.garment));
  const names = namesOf(pieces);
  const blocks = pieces.flatMap(({cut, grain, laid, crosses: marked}, k) => {
    const name = names[k] ?? '';
    return block(blockName(name), [
      ...text(layers.cut, grain[0], `Piece Name: ${name}`),
      ...text(layers.cut, grain[0], 'Quantity: 1,0'),
      ...text(layers.words, grain[0], name),
      ...(laid
        ? drawn(laid, format)
        : [
            ...polyline(layers.cut, cut, true, lineColours.cut.index),
            ...line(layers.grain, grain),
            ...crosses(marked.map((at, n) => ({at, number: n + 1}))),
          ]),
    ]);
  });
  const {widthCm, lengthCm, selvedgeCm} = plan;
  const along = (x: number): readonly [Point, Point] => [
    [x, 0],
    [x, lengthCm],
  ];
  const across = (y: number): readonly [Point, Point] => [
    [0, y],
    [widthCm, y],
  ];
  const edges = [...new Set([0, selvedgeCm, widthCm - selvedgeCm, widthCm])].map(along);
  const said = styleText({}, format);
  const entities = [
    ...said.flatMap((one, k) => text(layers.cut, [0, -2 - k], one)),
    ...names.flatMap((name) => insert(blockName(name))),
    ...[...edges, across(0), across(lengthCm)].flatMap((ends) => line(layers.inner, ends)),
  ];
  return dxfFile(blocks, entities, unit);
}
