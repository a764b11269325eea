/** Patterns as PDF in the habits of other people and programs, written as plain objects. */
import {createHash} from 'node:crypto';

export type Place = readonly [x: number, y: number];

/** A path in mm: points of straight lines, or the three points of a curve. */
export interface Outline {
  readonly start: Place;
  readonly steps: readonly (readonly [Place] | readonly [Place, Place, Place])[];
  readonly isOpen?: boolean;
}

export interface DrawnStroke {
  readonly outline: Outline;
  /** Operators that set the style, such as `1 0 0 RG [3 2] 0 d`. */
  readonly style?: string;
  readonly layer?: string;
}

export interface DrawnLabel {
  readonly at: Place;
  readonly text: string;
  readonly size?: number;
  readonly layer?: string;
}

/** A sheet of paper patterns. Lengths in mm, y up. */
export interface PatternSheet {
  readonly width: number;
  readonly height: number;
  readonly strokes: readonly DrawnStroke[];
  readonly labels: readonly DrawnLabel[];
}

/** A page of a file; its content is in mm. */
interface PdfPage {
  readonly width: number;
  readonly height: number;
  readonly content: string;
  /** Clockwise turn by viewers. [degrees] */
  readonly rotate?: number;
}

const points = 72 / 25.4;
const num = (value: number): string => String(Number(value.toFixed(4)));
const pair = ([x, y]: Place): string => `${num(x)} ${num(y)}`;

const operatorsOf = ({start, steps, isOpen}: Outline): string =>
  [
    `${pair(start)} m`,
    ...steps.map((step) => `${step.map(pair).join(' ')} ${step.length === 1 ? 'l' : 'c'}`),
    isOpen ? 'S' : 's',
  ].join('\n');

const onLayer = (layer: string | undefined, content: string): string =>
  layer === undefined ? content : `/OC /${nameOf(layer)} BDC\n${content}\nEMC`;

const nameOf = (layer: string): string => `L${Buffer.from(layer).toString('hex')}`;

const latin = (text: string): string =>
  Array.from(text, (letter) => {
    const code = letter.charCodeAt(0);
    if ('\\()'.includes(letter)) return `\\${letter}`;
    return code < 127 ? letter : `\\${code.toString(8)}`;
  }).join('');

const label = ({at, text, size = 6, layer}: DrawnLabel): string =>
  onLayer(layer, `BT /F1 ${num(size)} Tf ${pair(at)} Td (${latin(text)}) Tj ET`);

const stroke = ({outline, style = '0 G 0.4 w [] 0 d', layer}: DrawnStroke): string =>
  onLayer(layer, `q ${style}\n${operatorsOf(outline)}\nQ`);

export const contentOf = ({strokes, labels}: PatternSheet): string =>
  [...strokes.map(stroke), ...labels.map(label)].join('\n');

export interface Tiling {
  readonly paper: Place;
  /** Distance between the sides of the paper and of the drawn part. */
  readonly margin: number;
  /** Width that neighbouring tiles both show. */
  readonly overlap: number;
  /** Names such as A1, a border, or neither. */
  readonly names?: (row: number, column: number) => string;
  readonly hasBorder?: boolean;
  readonly rotate?: number;
}

/** The tiles of a sheet in reading order. */
export function tilesOf(sheet: PatternSheet, tiling: Tiling): PdfPage[] {
  const {paper, margin, overlap, names, hasBorder = false, rotate} = tiling;
  const [w, h] = [paper[0] - 2 * margin, paper[1] - 2 * margin];
  const count = (length: number, side: number): number =>
    Math.max(1, Math.ceil((length - overlap) / (side - overlap)));
  const [columns, rows] = [count(sheet.width, w), count(sheet.height, h)];
  const content = contentOf(sheet);
  return Array.from({length: rows * columns}, (_, k): PdfPage => {
    const [row, column] = [Math.floor(k / columns), k % columns];
    const left = column * (w - overlap);
    const low = sheet.height - row * (h - overlap) - h;
    const frame = `${num(margin)} ${num(margin)} ${num(w)} ${num(h)} re`;
    const inner = `${num(margin + overlap / 2)} ${num(margin + overlap / 2)} ${num(w - overlap)} ${num(h - overlap)} re`;
    const drawn = [
      `q ${frame} W n 1 0 0 1 ${num(margin - left)} ${num(margin - low)} cm\n${content}\nQ`,
      ...(hasBorder ? [`q 0.3 w 0.6 G ${inner} S Q`] : []),
      ...(names ? [label({at: [margin + 8, margin + 8], text: names(row, column), size: 8})] : []),
    ].join('\n');
    const page = {width: paper[0], height: paper[1], content: drawn};
    return rotate === undefined ? page : turnedPage(page, rotate);
  });
}

/** The page stored on its side, so that viewers turn it back. */
function turnedPage({width, height, content}: PdfPage, rotate: number): PdfPage {
  const map =
    {90: `0 1 -1 0 ${num(height)} 0`, 270: `0 -1 1 0 0 ${num(width)}`}[rotate] ?? '1 0 0 1 0 0';
  return {width: height, height: width, rotate, content: `q ${map} cm\n${content}\nQ`};
}

/** A page of words. */
export const wordsPage = ([width, height]: Place, lines: number): PdfPage => ({
  ...{width, height},
  content: Array.from({length: lines}, (_, k) =>
    label({
      at: [20, height - 20 - 6 * k],
      text: `Step ${String(k + 1)}: sew the side seams with right sides together and press them open.`,
      size: 4,
    }),
  ).join('\n'),
});

interface PdfFacts {
  readonly layers?: readonly string[];
  /** Encrypts the file so that it is readable without a password, or with this one only. */
  readonly lock?: {readonly user: string};
}

/** The bytes of a file. */
export function pdfOf(pages: readonly PdfPage[], {layers = [], lock}: PdfFacts = {}): Uint8Array {
  const objects: string[] = [];
  const add = (content: string): number => objects.push(content);
  add('');
  add('');
  const font = add('<</Type/Font/Subtype/Type1/BaseFont/Helvetica/Encoding/WinAnsiEncoding>>');
  const groups = layers.map((layer) => ({
    layer,
    ref: add(`<</Type/OCG/Name ${hexText(layer)}>>`),
  }));
  const properties = groups.map(({layer, ref}) => `/${nameOf(layer)} ${ref} 0 R`).join(' ');
  const resources = add(`<</Font<</F1 ${font} 0 R>>/Properties<<${properties}>>>>`);
  const refs = pages.map(({width, height, content, rotate}) => {
    const text = `${num(points)} 0 0 ${num(points)} 0 0 cm\n${content}`;
    const stream = add(`<</Length ${text.length}>>\nstream\n${text}\nendstream`);
    const box = `/MediaBox[0 0 ${num(width * points)} ${num(height * points)}]`;
    const turn = rotate === undefined ? '' : `/Rotate ${rotate}`;
    return add(
      `<</Type/Page/Parent 2 0 R${box}${turn}/Resources ${resources} 0 R/Contents ${stream} 0 R>>`,
    );
  });
  const all = groups.map(({ref}) => `${ref} 0 R`).join(' ');
  objects[0] = `<</Type/Catalog/Pages 2 0 R${layers.length > 0 ? `/OCProperties<</OCGs[${all}]/D<</Order[${all}]>>>>` : ''}>>`;
  objects[1] = `<</Type/Pages/Count ${refs.length}/Kids[${refs.map((ref) => `${ref} 0 R`).join(' ')}]>>`;
  return written(objects, lock);
}

const hexText = (text: string): string =>
  `<feff${Array.from(text, (letter) => letter.charCodeAt(0).toString(16).padStart(4, '0')).join('')}>`;

function written(objects: readonly string[], lock: PdfFacts['lock']): Uint8Array {
  const id = createHash('md5').update('pattern').digest();
  const security = lock && securityOf(lock.user, id);
  const whole = security
    ? [...objects.map((one, k) => encrypted(one, k + 1, security.key)), security.dictionary]
    : objects;
  let text = '%PDF-1.5\n';
  const places = whole.map((content, k) => {
    const place = text.length;
    text += `${k + 1} 0 obj\n${content}\nendobj\n`;
    return place;
  });
  const table = places.map((place) => `${String(place).padStart(10, '0')} 00000 n \n`).join('');
  const hexId = `<${id.toString('hex')}>`;
  const encrypt = security ? `/Encrypt ${whole.length} 0 R/ID[${hexId}${hexId}]` : '';
  const end = `xref\n0 ${whole.length + 1}\n0000000000 65535 f \n${table}trailer\n<</Size ${whole.length + 1}/Root 1 0 R${encrypt}>>\nstartxref\n${text.length}\n%%EOF\n`;
  return Uint8Array.from(Buffer.from(text + end, 'latin1'));
}

// The standard security handler, revision 2: RC4 with 40 bits.

const padding = Buffer.from(
  '28bf4e5e4e758a4164004e56fffa01082e2e00b6d0683e802f0ca9fe6453697a',
  'hex',
);

const md5 = (...parts: readonly Buffer[]): Buffer =>
  createHash('md5').update(Buffer.concat(parts)).digest();

function rc4(key: Buffer, data: Buffer): Buffer {
  const state = Array.from({length: 256}, (_, k) => k);
  const swap = (a: number, b: number): void => {
    [state[a], state[b]] = [state[b] ?? 0, state[a] ?? 0];
  };
  for (let i = 0, j = 0; i < 256; i++) {
    j = (j + (state[i] ?? 0) + (key[i % key.length] ?? 0)) % 256;
    swap(i, j);
  }
  let [i, j] = [0, 0];
  return data.map((byte) => {
    i = (i + 1) % 256;
    j = (j + (state[i] ?? 0)) % 256;
    swap(i, j);
    return byte ^ (state[((state[i] ?? 0) + (state[j] ?? 0)) % 256] ?? 0);
  }) as Buffer;
}

const padded = (password: string): Buffer =>
  Buffer.concat([Buffer.from(password, 'latin1'), padding]).subarray(0, 32);

function securityOf(user: string, id: Buffer): {readonly key: Buffer; readonly dictionary: string} {
  const permissions = -44; // reading and printing
  const flags = Buffer.alloc(4);
  flags.writeInt32LE(permissions);
  const owner = rc4(md5(padded('owner')).subarray(0, 5), padded(user));
  const key = md5(padded(user), owner, flags, id).subarray(0, 5);
  const check = rc4(key, padding);
  return {
    key,
    dictionary: `<</Filter/Standard/V 1/R 2/O<${owner.toString('hex')}>/U<${check.toString('hex')}>/P ${permissions}>>`,
  };
}

/** Encrypts the stream of an object; the names of layers are the only strings. */
function encrypted(content: string, number: number, key: Buffer): string {
  const own = Buffer.concat([key, Buffer.from([number & 255, (number >> 8) & 255, 0, 0, 0])]);
  const objectKey = md5(own).subarray(0, 10);
  return content.replace(
    /(stream\n)([^]*)(\nendstream)$/,
    (_, begin: string, body: string, end: string) =>
      [begin, rc4(objectKey, Buffer.from(body, 'latin1')).toString('latin1'), end].join(''),
  );
}
