/** Parses a PDF for tests by its cross-reference table, without a PDF library. */
import {inflateSync} from 'node:zlib';

export interface PdfObject {
  readonly text: string;
  /** Decompressed if Flate is its only filter. */
  readonly stream?: string;
  /** The stream as in the file. */
  readonly data?: Uint8Array;
}

export interface ReadPdf {
  readonly objects: ReadonlyMap<number, PdfObject>;
  /** Pages in their order. */
  /** Pages in their order; texts of their contents are in letters, as `(text) Tj`. */
  readonly pages: readonly {readonly size: readonly number[]; readonly content: string}[];
}

const latin = (bytes: Uint8Array): string => Buffer.from(bytes).toString('latin1');

/** The letters of each font by their codes, from its map to Unicode. */
function lettersOf(
  {text}: PdfObject,
  get: (ref: string | undefined) => PdfObject,
): ReadonlyMap<string, string> {
  const {stream = ''} = get(/\/ToUnicode (\d+) 0 R/.exec(text)?.[1]);
  return new Map(
    [...stream.matchAll(/^<(\w{4})> <(\w+)>$/gm)].map(([, code = '', units = '']) => [
      code,
      String.fromCharCode(...(units.match(/.{4}/g) ?? []).map((unit) => parseInt(unit, 16))),
    ]),
  );
}

/** @throws {Error} if the table does not point to objects */
export function readPdf(bytes: Uint8Array): ReadPdf {
  const whole = latin(bytes);
  const table = Number(/startxref\n(\d+)\n%%EOF\n$/.exec(whole)?.[1]);
  const entries = /^xref\n0 (\d+)\n0{10} 65535 f \n((?:\d{10} 00000 n \n)*)trailer\n(.*)\n/.exec(
    whole.slice(table),
  );
  if (!entries) throw new Error('no table');
  const places = (entries[2] ?? '').split('\n').flatMap((line) => line.slice(0, 10) || []);
  if (places.length + 1 !== Number(entries[1])) throw new Error('the table has another size');
  const objects = new Map(
    places.map((place, k): [number, PdfObject] => {
      const from = Number(place);
      const begin = `${k + 1} 0 obj\n`;
      if (!whole.startsWith(begin, from)) throw new Error(`object ${k + 1} is elsewhere`);
      const end = whole.indexOf('\nendobj\n', from);
      const body = whole.slice(from + begin.length, end);
      const at = body.indexOf('>>\nstream\n');
      if (at < 0) return [k + 1, {text: body}];
      const text = body.slice(0, at + 2);
      const length = Number(/\/Length (\d+)>>$/.exec(text)?.[1]);
      const start = from + begin.length + at + '>>\nstream\n'.length;
      if (!whole.startsWith('\nendstream\nendobj\n', start + length)) throw new Error('a length');
      const data = bytes.slice(start, start + length);
      return [
        k + 1,
        {text, data, stream: latin(text.includes('FlateDecode') ? inflateSync(data) : data)},
      ];
    }),
  );
  const get = (ref: string | undefined): PdfObject => {
    const found = objects.get(Number(ref));
    if (!found) throw new Error(`no object ${ref ?? ''}`);
    return found;
  };
  const root = get(/\/Root (\d+) 0 R/.exec(entries[3] ?? '')?.[1]);
  const tree = get(/\/Pages (\d+) 0 R/.exec(root.text)?.[1]);
  const kids = /\/Kids\[([^\]]*)\]/.exec(tree.text)?.[1] ?? '';
  const pages = [...kids.matchAll(/(\d+) 0 R/g)].map(([, ref]) => {
    const {text} = get(ref);
    return {
      size: (/\/MediaBox\[0 0 ([^\]]*)\]/.exec(text)?.[1] ?? '').split(' ').map(Number),
      content: get(/\/Contents (\d+) 0 R/.exec(text)?.[1]).stream ?? '',
    };
  });
  const fonts = new Map(
    [...objects.values()].flatMap(({text}) => {
      const list = /^\/Font<<(.*)>>$/m.exec(text)?.[1] ?? '';
      return [...list.matchAll(/\/(\w+) (\d+) 0 R/g)].map(
        ([, name = '', ref]) => [name, lettersOf(get(ref), get)] as const,
      );
    }),
  );
  const readable = (content: string): string =>
    content.replaceAll(
      /^\/(\w+) (\S+ Tf\n.*\n)<(\w*)> Tj$/gm,
      (_, font: string, between: string, codes: string) => {
        const letters = (codes.match(/.{4}/g) ?? []).map((code) => fonts.get(font)?.get(code));
        return `/${font} ${between}(${letters.join('')}) Tj`;
      },
    );
  return {
    objects,
    pages: pages.map(({size, content}) => ({size, content: readable(content)})),
  };
}
