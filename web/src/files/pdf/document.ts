/** A PDF file of numbered, compressed objects. The same content gives the same bytes. */

/** The number of an object. */
export type Ref = number;

interface PdfObject {
  readonly head: string;
  readonly data?: Uint8Array<ArrayBuffer>;
  readonly isPacked?: boolean;
}

const encoder = new TextEncoder();

export const refTo = (ref: Ref): string => `${ref} 0 R`;

/**
 * A text string in any script, for viewers' lists; content streams use letters of their fonts
 * instead.
 */
export function textString(text: string): string {
  if (/^[ -~]*$/.test(text)) return `(${text.replaceAll(/[\\()]/g, String.raw`\$&`)})`;
  const units = Array.from({length: text.length}, (_, k) =>
    text.charCodeAt(k).toString(16).padStart(4, '0'),
  );
  return `<feff${units.join('')}>`;
}

/** A date such as `D:20261124225800Z`. */
export const dateString = (date: Date): string =>
  `(D:${date.toISOString().replaceAll(/[-:T]/g, '').slice(0, 14)}Z)`;

async function packed(data: Uint8Array<ArrayBuffer>): Promise<Uint8Array<ArrayBuffer>> {
  const stream = new Blob([data]).stream().pipeThrough(new CompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

export class PdfDocument {
  readonly #objects: (PdfObject | undefined)[] = [];

  /** Reserves a number for an object that is set later. */
  reserve(): Ref {
    return this.#objects.push(undefined);
  }

  set(ref: Ref, content: string): void {
    this.#objects[ref - 1] = {head: content};
  }

  add(content: string): Ref {
    return this.#objects.push({head: content});
  }

  /**
   * Adds a stream, compressed on writing.
   * @param entries entries of the stream's dictionary, without its length
   */
  stream(entries: string, content: string | Uint8Array<ArrayBuffer>): Ref {
    const ref = this.reserve();
    this.setStream(ref, entries, content);
    return ref;
  }

  /** Sets a stream as an object that was reserved. */
  setStream(ref: Ref, entries: string, content: string | Uint8Array<ArrayBuffer>): void {
    const data = typeof content === 'string' ? encoder.encode(content) : content;
    this.#objects[ref - 1] = {head: entries, data};
  }

  /** Adds bytes that are already compressed, as stated in `entries`. */
  packedStream(entries: string, data: Uint8Array<ArrayBuffer>): Ref {
    return this.#objects.push({head: entries, data, isPacked: true});
  }

  async bytes(catalog: Ref, info: Ref): Promise<Uint8Array<ArrayBuffer>> {
    const parts: Uint8Array<ArrayBuffer>[] = [];
    const places: number[] = [];
    let length = 0;
    const write = (part: string | Uint8Array<ArrayBuffer>): void => {
      const bytes = typeof part === 'string' ? encoder.encode(part) : part;
      parts.push(bytes);
      length += bytes.length;
    };
    // bytes beyond ASCII mark the file as binary for transfer programs
    write('%PDF-1.7\n');
    write(Uint8Array.of(0x25, 0xe2, 0xe3, 0xcf, 0xd3, 0x0a));
    for (const [k, object] of this.#objects.entries()) {
      if (!object) throw new Error(`object ${k + 1} was never written`);
      places.push(length);
      write(`${k + 1} 0 obj\n`);
      const {head, data, isPacked} = object;
      if (data) {
        const body = isPacked ? data : await packed(data);
        const filter = isPacked ? '' : '/Filter/FlateDecode';
        write(`<<${head}${filter}/Length ${body.length}>>\nstream\n`);
        write(body);
        write('\nendstream');
      } else write(head);
      write('\nendobj\n');
    }
    const table = length;
    const lines = places.map((place) => `${String(place).padStart(10, '0')} 00000 n \n`);
    const size = places.length + 1;
    write(`xref\n0 ${size}\n0000000000 65535 f \n${lines.join('')}`);
    write(`trailer\n<</Size ${size}/Root ${refTo(catalog)}/Info ${refTo(info)}>>\n`);
    write(`startxref\n${table}\n%%EOF\n`);
    return new Uint8Array(await new Blob(parts).arrayBuffer());
  }
}
