/** Draws pages of our PDF files in pixels: areas, lines, images, clips and opacities, no text. */
import {
  createCanvas,
  loadImage,
  type Canvas,
  type Image,
  type SKRSContext2D,
} from '@napi-rs/canvas';

import type {Pixels} from '@/image/tile-fabric.js';
import {asPng} from '../image/raw-png.js';
import {readPdf, type PdfObject, type ReadPdf} from './pdf.js';

type Context = SKRSContext2D;

interface Brush {
  fill: string;
  stroke: string;
  opacity: number;
}

const numbers = (text: string | undefined): number[] =>
  (text ?? '').trim().split(/\s+/).filter(Boolean).map(Number);

const arrayOf = (text: string, key: string): number[] =>
  numbers(new RegExp(String.raw`/${key}\[([^\]]*)\]`).exec(text)?.[1]);

const hexColour = (parts: readonly number[]): string =>
  `#${parts
    .map((part) =>
      Math.round(255 * part)
        .toString(16)
        .padStart(2, '0'),
    )
    .join('')}`;

/** Numbers, names, strings, arrays and operators. */
const token = /\/\S+|\((?:\\.|[^\\)])*\)|\[[^\]]*\]|[^\s[\]()/]+/g;

class PageDrawing {
  readonly #pdf: ReadPdf;
  readonly #resources: string;
  readonly #images: ReadonlyMap<string, Image>;

  constructor(pdf: ReadPdf, resources: string, images: ReadonlyMap<string, Image>) {
    this.#pdf = pdf;
    this.#resources = resources;
    this.#images = images;
  }

  /** The object of a name, such as `X0`. */
  #object(name: string): PdfObject {
    const ref = new RegExp(String.raw`/${name} (\d+) 0 R`).exec(this.#resources)?.[1];
    const found = this.#pdf.objects.get(Number(ref));
    if (!found) throw new Error(`no object ${name}`);
    return found;
  }

  #opacity(name: string): number {
    return Number(new RegExp(String.raw`/${name}<<[^>]*/ca ([\d.]+)`).exec(this.#resources)?.[1]);
  }

  content(text: string, context: Context, outer: Brush): void {
    const brushes: Brush[] = [];
    let brush = {...outer};
    let operands: string[] = [];
    let clip: 'nonzero' | 'evenodd' | undefined;
    const value = (k: number): number => Number(operands[k]);
    const paint = (fill: 'nonzero' | 'evenodd' | undefined, isStroked: boolean): void => {
      context.globalAlpha = brush.opacity;
      if (fill) {
        context.fillStyle = brush.fill;
        context.fill(fill);
      }
      if (isStroked) {
        context.strokeStyle = brush.stroke;
        context.stroke();
      }
      if (clip) context.clip(clip);
      clip = undefined;
      context.beginPath();
    };
    context.beginPath();
    const operators: Readonly<Record<string, () => void>> = {
      q: () => {
        brushes.push({...brush});
        context.save();
      },
      Q: () => {
        brush = brushes.pop() ?? brush;
        context.restore();
      },
      cm: () => {
        context.transform(value(0), value(1), value(2), value(3), value(4), value(5));
      },
      m: () => {
        context.moveTo(value(0), value(1));
      },
      l: () => {
        context.lineTo(value(0), value(1));
      },
      c: () => {
        context.bezierCurveTo(value(0), value(1), value(2), value(3), value(4), value(5));
      },
      h: () => {
        context.closePath();
      },
      re: () => {
        context.rect(value(0), value(1), value(2), value(3));
      },
      W: () => (clip = 'nonzero'),
      'W*': () => (clip = 'evenodd'),
      n: () => {
        paint(undefined, false);
      },
      f: () => {
        paint('nonzero', false);
      },
      'f*': () => {
        paint('evenodd', false);
      },
      S: () => {
        paint(undefined, true);
      },
      B: () => {
        paint('nonzero', true);
      },
      'B*': () => {
        paint('evenodd', true);
      },
      rg: () => (brush.fill = hexColour(operands.map(Number))),
      RG: () => (brush.stroke = hexColour(operands.map(Number))),
      w: () => (context.lineWidth = value(0)),
      J: () => (context.lineCap = (['butt', 'round', 'square'] as const)[value(0)] ?? 'butt'),
      j: () => (context.lineJoin = (['miter', 'round', 'bevel'] as const)[value(0)] ?? 'miter'),
      d: () => {
        context.setLineDash(numbers(operands[0]?.slice(1, -1)));
      },
      gs: () => (brush.opacity = this.#opacity((operands[0] ?? '').slice(1))),
      Do: () => {
        this.#placed((operands[0] ?? '').slice(1), context, brush);
        context.beginPath();
      },
    };
    for (const [word] of text.matchAll(token)) {
      if (/^[-+.\d/([]/.test(word)) operands.push(word);
      else {
        operators[word]?.();
        operands = [];
      }
    }
  }

  #placed(name: string, context: Context, brush: Brush): void {
    const image = this.#images.get(name);
    context.save();
    if (image) {
      context.transform(1, 0, 0, -1, 0, 1);
      context.globalAlpha = brush.opacity;
      context.drawImage(image, 0, 0, 1, 1);
    } else this.#form(this.#object(name), context, brush);
    context.restore();
  }

  #form({text, stream = ''}: PdfObject, context: Context, brush: Brush): void {
    const [a = 1, b = 0, c = 0, d = 1, e = 0, f = 0] = arrayOf(text, 'Matrix');
    const isGroup = text.includes('/Transparency');
    const {canvas} = context as unknown as {canvas: Canvas};
    const own = isGroup ? createCanvas(canvas.width, canvas.height).getContext('2d') : context;
    if (isGroup) own.setTransform(context.getTransform());
    own.transform(a, b, c, d, e, f);
    const [left = 0, low = 0, right = 0, high = 0] = arrayOf(text, 'BBox');
    own.beginPath();
    own.rect(left, low, right - left, high - low);
    own.clip();
    this.content(stream, own, isGroup ? {...brush, opacity: 1} : brush);
    if (!isGroup) return;
    context.resetTransform();
    context.globalAlpha = brush.opacity;
    context.drawImage(own.canvas, 0, 0);
  }
}

/** The images of a file by name, in which PNG data and JPEG files stay unchanged. */
async function imagesIn(pdf: ReadPdf, resources: string): Promise<ReadonlyMap<string, Image>> {
  const images = new Map<string, Image>();
  for (const [, name = '', ref] of resources.matchAll(/\/(X\d+) (\d+) 0 R/g)) {
    const {text, data} = pdf.objects.get(Number(ref)) ?? {text: ''};
    if (!text.includes('/Subtype/Image') || !data) continue;
    const [width = 0, height = 0] = ['Width', 'Height'].map((key) =>
      Number(new RegExp(String.raw`/${key} (\d+)`).exec(text)?.[1]),
    );
    const palette = /<([\da-f]+)>\]/.exec(text)?.[1];
    const kind = palette === undefined ? (text.includes('DeviceGray') ? 0 : 2) : 3;
    const file = text.includes('DCTDecode')
      ? Buffer.from(data)
      : asPng({width, height, kind, data, palette: Buffer.from(palette ?? '', 'hex')});
    images.set(name, await loadImage(file));
  }
  return images;
}

/** Draws pages, numbered from 0. */
export async function drawnPages(
  bytes: Uint8Array,
  pages: readonly number[],
  dpi: number,
): Promise<readonly Pixels[]> {
  const pdf = readPdf(bytes);
  const resources =
    [...pdf.objects.values()].find(({text}) => text.startsWith('<<\n/Font'))?.text ?? '';
  const drawing = new PageDrawing(pdf, resources, await imagesIn(pdf, resources));
  return pages.map((page) => {
    const {size = [], content = ''} = pdf.pages[page] ?? {};
    const [width = 0, height = 0] = size.map((points) => Math.round((points * dpi) / 72));
    const canvas = createCanvas(width, height);
    const context = canvas.getContext('2d');
    context.fillStyle = '#fff';
    context.fillRect(0, 0, width, height);
    context.setTransform(dpi / 72, 0, 0, -dpi / 72, 0, height);
    drawing.content(content, context, {fill: '#000000', stroke: '#000000', opacity: 1});
    return context.getImageData(0, 0, width, height);
  });
}
