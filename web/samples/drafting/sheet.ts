/**
 * One image of several garments with every piece flat: names, grain, notches, and the numbers of
 * seams.
 */
import {
  leftOf,
  middle,
  minus,
  norm,
  plus,
  unit,
  type Point,
} from '../../src/model/geometry/vectors.js';
import {escaped, short, text} from '../../src/files/svg/written.js';
import {grainLine, notchesOf, titled} from './garment-file.js';
import {parameterAt, pointAt, velocity, type Curve} from './curves.js';
import {findEdge, type EdgeName, type Garment, type Panel, type Seam} from './panel.js';
import {layOutSheet, type Placed} from './sheet-layout.js';

const width = 1400;
const margin = 56;
/** Room for the pieces of one garment; many small ones get more. [px] */
const pieceRoom = (pieces: number): number => (pieces > 20 ? 1000 : 640);
const largestScale = 8;
const nameSize = 11;
const numberSize = 9;
const ink = '#26282c';
const soft = '#6a6d73';
const paper = '#fbfaf8';
const fabric = '#efece4';
const line = '#4a4d52';

const dot = ([x, y]: Point): string => `${x.toFixed(1)} ${y.toFixed(1)}`;
const stroke = (from: Point, to: Point): string => `M${dot(from)}L${dot(to)}`;

function outline({panel, toPage}: Placed): string {
  const edges = panel.edges.map(({curve: {controls, to}}) =>
    controls ? `C${[...controls, to].map((p) => dot(toPage(p))).join(' ')}` : `L${dot(toPage(to))}`,
  );
  const start = panel.edges[0]?.curve.from ?? [0, 0];
  return `<path d="M${dot(toPage(start))}${edges.join('')}Z"/>`;
}

/** The middle four fifths of the grain line, with a head at both ends. */
function grain({panel, toPage}: Placed): string {
  const [low, high] = grainLine(panel);
  const span = minus(high, low);
  const [from, to] = [toPage(plus(low, span, 0.1)), toPage(plus(low, span, 0.9))];
  const along = unit(minus(to, from));
  const head = (tip: Point, way: number): string => {
    const back = plus(tip, along, -5 * way);
    return `M${dot(plus(back, leftOf(along), 2))}L${dot(tip)}L${dot(plus(back, leftOf(along), -2))}`;
  };
  return stroke(from, to) + head(to, 1) + head(from, -1);
}

/** A point of an edge on the page, and the direction into the piece there. */
function onEdge({toPage}: Placed, curve: Curve, share: number): readonly [Point, Point] {
  const t = parameterAt(curve, share);
  const [x, y] = unit(leftOf(velocity(curve, t)));
  return [toPage(pointAt(curve, t)), [x, -y]];
}

/** Ticks at the ends of edges, across the outline, on its outer side. */
function edgeEnds(placed: Placed): string {
  return placed.panel.edges
    .map(({curve}, k, edges) => {
      const before = edges.at(k - 1)?.curve ?? curve;
      const [point, inward] = onEdge(placed, curve, 0);
      const [, inwardBefore] = onEdge(placed, before, 1);
      const out = plus(inward, inwardBefore);
      return norm(out) < 0.1 ? '' : stroke(point, plus(point, out, -4 / norm(out)));
    })
    .join('');
}

function notches(placed: Placed, garment: Garment): string {
  return notchesOf(placed.panel, garment)
    .map(({edge, at}) => {
      const curve = placed.panel.edges[edge]?.curve;
      if (!curve) return '';
      const [point, inward] = onEdge(placed, curve, at);
      return stroke(point, plus(point, inward, 6));
    })
    .join('');
}

/** The place of a dart's only number, at its mouth and in line with its tip. */
function dartNumber({toPage}: Placed, garment: Garment, {a, b}: Seam): Point {
  const legs = [a, b].map((leg) => findEdge(garment, leg));
  const [first, second] = legs.toSorted((one, other) => one.index - other.index);
  if (!first || !second) throw new Error('a dart has two legs');
  const mouth = toPage(middle(first.curve.from, second.curve.to));
  const out = minus(mouth, toPage(first.curve.to));
  return plus(mouth, out, numberSize / norm(out));
}

/** Name of a seam without its side, as left and right are one seam for a sewist. */
const bothSides = ({name}: Seam): string => name.replace(/, (left|right)$/, '');

const seamNames = ({seams}: Garment): string[] => [...new Set(seams.map(bothSides))];

function numbers(placed: Placed, garment: Garment): string {
  const names = seamNames(garment);
  return garment.seams
    .flatMap((seam) =>
      (seam.kind === 'dart' ? [seam.a] : [seam.a, seam.b])
        .filter(([name]) => name === placed.panel.name)
        .map((edge: EdgeName) => {
          const [point, inward] = onEdge(placed, findEdge(garment, edge).curve, 0.5);
          const [x, y] =
            seam.kind === 'dart'
              ? dartNumber(placed, garment, seam)
              : plus(point, inward, -numberSize);
          return `<text x="${short(x)}" y="${short(y + numberSize / 3)}">${names.indexOf(bothSides(seam)) + 1}</text>`;
        }),
    )
    .join('');
}

/** Distance from the outline to a line drawn inside of it. [px] */
const insideOutline = 4;

/** A straight line of two points on an edge, moved into the piece so that it is visible. */
function offOutline(placed: Placed, points: readonly Point[]): Point[] {
  const onPage = points.map(placed.toPage);
  const [from, to] = points;
  if (!from || !to || points.length > 2) return onPage;
  const along = minus(to, from);
  const off = (p: Point): number =>
    Math.abs(along[0] * (p[1] - from[1]) - along[1] * (p[0] - from[0])) / norm(along);
  const under = placed.panel.edges.find(
    ({curve}) => !curve.controls && off(curve.from) < 0.05 && off(curve.to) < 0.05,
  );
  if (!under) return onPage;
  const [, inward] = onEdge(placed, under.curve, 0.5);
  return onPage.map((p) => plus(p, inward, insideOutline));
}

function matchLines(placed: Placed, {matches = []}: Garment): string {
  return matches
    .flatMap(({a, b}) => [a, b])
    .filter(({panel}) => panel === placed.panel.name)
    .map(({line: points}) => `M${offOutline(placed, points).map(dot).join('L')}`)
    .join('');
}

/** A piece's name, and the number to cut: a mirrored pair is marked as such. */
const pieceLine = ({name}: Panel, {symmetries}: Garment): string =>
  `${titled(name)}, ${symmetries.some((names) => names.length === 2 && names.includes(name)) ? 'pair' : 'cut 1'}`;

const lineWidth = (content: string): number => 0.56 * nameSize * content.length;

/**
 * "3  Front armhole, ease 1.0 cm (stitches 4, 5)", in columns; options name a seam by its stitch.
 */
function legend(garment: Garment, top: number): {readonly svg: string; readonly height: number} {
  const lines = seamNames(garment).map((name, k) => {
    const seam = garment.seams.find((one) => bothSides(one) === name);
    const manner = seam?.gathers
      ? `, ${seam.gathers} : 1`
      : seam?.ease
        ? `, ease ${seam.ease.toFixed(1)} cm`
        : '';
    const stitches = garment.seams.flatMap((one, at) => (bothSides(one) === name ? [at] : []));
    const which = `${stitches.length > 1 ? 'stitches' : 'stitch'} ${stitches.join(', ')}`;
    return `${k + 1}  ${name}${manner} (${which})`;
  });
  const columns = 4;
  const rows = Math.ceil(lines.length / columns);
  const step = 15;
  const svg = lines.map((content, k) => {
    const x = margin + (Math.floor(k / rows) * (width - 2 * margin)) / columns;
    return text([x, top + (k % rows) * step], content, {size: 10.5, fill: soft});
  });
  return {svg: svg.join(''), height: rows * step};
}

function garmentBlock(
  garment: Garment,
  top: number,
): {readonly svg: string; readonly foot: number} {
  const layout = layOutSheet(
    garment,
    [margin, top + 56],
    {
      width: width - 2 * margin,
      height: pieceRoom(garment.panels.length),
      gap: 36,
      name: {height: 52, width: (panel) => lineWidth(pieceLine(panel, garment))},
    },
    largestScale,
  );
  const {pieces, scale} = layout;
  const end = width - margin;
  const seams = seamNames(garment).length;
  const note = `${garment.panels.length} pieces, ${garment.seams.length} seams, ${seams} of them different`;
  const below = legend(garment, top + 56 + layout.height + 18);
  const svg = [
    `<path d="M${margin} ${top}H${end}" stroke="#d5d3cd"/>`,
    text([margin, top + 28], garment.title, {size: 18, weight: 600, fill: ink}),
    text([margin + garment.title.length * 11 + 20, top + 28], note, {size: 12, fill: soft}),
    `<path d="M${short(end - 10 * scale)} ${top + 20}v6H${end}v-6" fill="none" stroke="${soft}"/>`,
    text([end - 10 * scale - 8, top + 28], '10 cm', {size: 12, fill: soft, anchor: 'end'}),
    `<g fill="${fabric}" stroke="${line}" stroke-width="1.1" stroke-linejoin="round">${pieces.map(outline).join('')}</g>`,
    `<path d="${pieces.map(grain).join('')}" fill="none" stroke="#9a9488" stroke-width="0.8"/>`,
    `<path d="${pieces.map((one) => notches(one, garment)).join('')}" fill="none" stroke="${line}"/>`,
    `<path d="${pieces.map(edgeEnds).join('')}" fill="none" stroke="${line}" stroke-width="0.8"/>`,
    `<path d="${pieces.map((one) => matchLines(one, garment)).join('')}" fill="none" stroke="#8a5a2b" stroke-width="0.9" stroke-dasharray="5 3"/>`,
    `<g font-size="${numberSize}" fill="#8a5a2b" text-anchor="middle">${pieces.map((one) => numbers(one, garment)).join('')}</g>`,
    ...pieces.map(({panel, foot}) =>
      text([foot[0], foot[1] + 28], pieceLine(panel, garment), {
        size: nameSize,
        anchor: 'middle',
        fill: '#44474d',
      }),
    ),
    below.svg,
  ].join('\n');
  return {
    svg: `<g aria-label="${escaped(garment.title)}">${svg}</g>`,
    foot: top + 56 + layout.height + 18 + below.height + 40,
  };
}

/** The garments one below the other, each at a separate scale. */
export function garmentSheet(garments: readonly Garment[], title: string, note: string): string {
  const blocks: string[] = [];
  let top = 110;
  for (const garment of garments) {
    const {svg, foot} = garmentBlock(garment, top);
    blocks.push(svg);
    top = foot;
  }
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${Math.ceil(top)}" width="${width}" height="${Math.ceil(top)}" font-family="'Helvetica Neue', Helvetica, Arial, 'Liberation Sans', sans-serif" role="img" aria-label="${escaped(title)}">`,
    `<rect width="100%" height="100%" fill="${paper}"/>`,
    text([margin, 54], title, {size: 26, weight: 650, fill: ink}),
    text([margin, 78], note, {size: 13, fill: soft}),
    ...blocks,
    '</svg>\n',
  ].join('\n');
}
