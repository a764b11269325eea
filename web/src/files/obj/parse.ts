/** Parses an OBJ file to a triangle mesh, byte by byte, since files have millions of lines. */
import {FileError} from '../../model/base/versioned-file.js';
import {Floats, Integers} from './arrays.js';

/** A triangle mesh; corners are indexed, three per triangle. */
export interface ObjMesh {
  /** x, y, z per vertex. */
  readonly vertices: Float64Array;
  /** u, v per texture coordinate. */
  readonly flat: Float64Array;
  /** Vertex index per corner. */
  readonly corners: Int32Array;
  /** Index of the texture coordinate per corner. */
  readonly flatCorners: Int32Array;
  /** Group index per triangle. */
  readonly groups: Int32Array;
  readonly groupNames: readonly string[];
  /** True if there are texture coordinates. */
  readonly hasFlat: boolean;
}

const code = (character: string): number => character.charCodeAt(0);
const backslash = code('\\');
const [newline, carriage, space, tab, slash, minusSign, plusSign, dot, zero, nine] = [
  ...[10, 13, 32, 9],
  ...['/', '-', '+', '.', '0', '9'].map(code),
] as [number, number, number, number, number, number, number, number, number, number];

/** Greatest number of triangles, five times that of simulators' garments. */
const mostTriangles = 500_000;

/**
 * Parses an OBJ file.
 * @throws {FileError} for an invalid number, or a face with an unknown index
 */
export const readMesh = (bytes: Uint8Array, file: string): ObjMesh =>
  new Parser(withPlainLines(bytes), file).read();

/** The bytes with LF at the end of each line, and blanks where a backslash continues a line. */
function withPlainLines(bytes: Uint8Array): Uint8Array {
  const isPlain =
    !bytes.includes(backslash) && (bytes.includes(newline) || !bytes.includes(carriage));
  if (isPlain) return bytes;
  const lines = bytes.slice();
  const hasNewlines = bytes.includes(newline);
  lines.forEach((byte, k) => {
    if (byte === carriage && !hasNewlines) lines[k] = newline;
    if (byte !== backslash || !isLineEnd(lines[k + 1])) return;
    const isPair = lines[k + 1] === carriage && lines[k + 2] === newline;
    lines.fill(space, k, k + (isPair ? 3 : 2));
  });
  return lines;
}

class Parser {
  readonly #bytes: Uint8Array;
  readonly #file: string;
  readonly #vertices = new Floats();
  readonly #flat = new Floats();
  readonly #corners = new Integers();
  readonly #flatCorners = new Integers();
  readonly #groups = new Integers();
  readonly #groupNames = new Map<string, number>([['', 0]]);
  #group = 0;
  #at = 0;
  #line = 0;

  constructor(bytes: Uint8Array, file: string) {
    this.#bytes = bytes;
    this.#file = file;
  }

  read(): ObjMesh {
    while (this.#at < this.#bytes.length) {
      this.#line++;
      this.#skipBlanks();
      this.#statement();
      this.#nextLine();
    }
    return {
      vertices: this.#vertices.all(),
      flat: this.#flat.all(),
      corners: this.#corners.all(),
      flatCorners: this.#flatCorners.all(),
      groups: this.#groups.all(),
      groupNames: [...this.#groupNames.keys()],
      hasFlat: this.#flat.length > 0,
    };
  }

  #statement(): void {
    const [first = 0, second = 0, third = 0] = this.#bytes.subarray(this.#at, this.#at + 3);
    const isWord = (after: number): boolean => after === space || after === tab;
    if (first === code('v') && isWord(second)) this.#numbers(1, 3, this.#vertices);
    else if (first === code('v') && second === code('t') && isWord(third))
      this.#numbers(2, 2, this.#flat);
    else if (first === code('f') && isWord(second)) this.#face();
    else if ((first === code('g') || first === code('o')) && isWord(second)) this.#name();
  }

  #numbers(skip: number, count: number, into: Floats): void {
    this.#at += skip;
    for (let k = 0; k < count; k++) {
      this.#skipBlanks();
      into.push(this.#number());
    }
  }

  #number(): number {
    const start = this.#at;
    const bytes = this.#bytes;
    const sign = this.#sign();
    let [value, digits] = [0, 0];
    for (; isDigit(bytes[this.#at]); this.#at++, digits++)
      value = 10 * value + (bytes[this.#at] ?? 0) - zero;
    let decimals = 0;
    if (bytes[this.#at] === dot) {
      for (this.#at++; isDigit(bytes[this.#at]); this.#at++, decimals++) {
        value = 10 * value + (bytes[this.#at] ?? 0) - zero;
      }
    }
    const exponent = ((bytes[this.#at] ?? 0) | 32) === code('e') ? this.#exponent() : 0;
    const number = sign * (exponent === decimals ? value : value * 10 ** (exponent - decimals));
    if (digits + decimals > 0 && this.#isAtEnd() && Math.abs(number) <= 1e9) return number;
    return this.#fail(`has '${this.#wordAt(start)}' where a number should be`);
  }

  #exponent(): number {
    this.#at++;
    const sign = this.#sign();
    let value = 0;
    for (; isDigit(this.#bytes[this.#at]); this.#at++)
      value = 10 * value + (this.#bytes[this.#at] ?? 0) - zero;
    return sign * value;
  }

  #sign(): number {
    const first = this.#bytes[this.#at];
    if (first === minusSign || first === plusSign) this.#at++;
    return first === minusSign ? -1 : 1;
  }

  /** Converts a polygon to a fan of triangles. */
  #face(): void {
    this.#at++;
    const group = this.#group;
    const [corners, flat] = [this.#corners, this.#flatCorners];
    let [first, firstFlat, last, lastFlat] = [-1, -1, -1, -1];
    for (let k = 0; ; k++) {
      this.#skipBlanks();
      if (!isDigit(this.#bytes[this.#at]) && this.#bytes[this.#at] !== minusSign) break;
      const vertex = this.#index(this.#vertices.length / 3, 'vertex');
      const point = this.#bytes[this.#at] === slash ? this.#flatIndex() : -1;
      if (k === 0) [first, firstFlat] = [vertex, point];
      if (k > 1) {
        corners.push3(first, last, vertex);
        flat.push3(firstFlat, lastFlat, point);
        this.#groups.push(group);
        if (this.#groups.length > mostTriangles) this.#refuseSize();
      }
      [last, lastFlat] = [vertex, point];
    }
  }

  #refuseSize(): never {
    throw new FileError(
      this.#file,
      `has more than ${mostTriangles} triangles, which no garment needs; export a coarser mesh.`,
      {reason: 'complex'},
    );
  }

  #flatIndex(): number {
    this.#at++;
    const next = this.#bytes[this.#at];
    const index =
      isDigit(next) || next === minusSign
        ? this.#index(this.#flat.length / 2, 'texture coordinate')
        : -1;
    while (!this.#isAtEnd()) this.#at++; // skips the normal
    return index;
  }

  /** Reads an index: counted from 1, or backwards from the latest element if negative. */
  #index(count: number, what: string): number {
    const start = this.#at;
    const sign = this.#sign();
    let value = 0;
    for (; isDigit(this.#bytes[this.#at]); this.#at++)
      value = 10 * value + (this.#bytes[this.#at] ?? 0) - zero;
    const index = sign < 0 ? count - value : value - 1;
    if (value > 0 && index >= 0 && index < count) return index;
    return this.#fail(
      `names ${what} ${this.#wordAt(start).split('/')[0] ?? ''}, of which there are ${count} so far`,
    );
  }

  #name(): void {
    const start = ++this.#at;
    while (this.#at < this.#bytes.length && !isLineEnd(this.#bytes[this.#at])) this.#at++;
    const name = new TextDecoder().decode(this.#bytes.subarray(start, this.#at)).trim();
    const known = this.#groupNames.get(name);
    this.#group = known ?? this.#groupNames.size;
    if (known === undefined) this.#groupNames.set(name, this.#group);
  }

  #wordAt(start: number): string {
    let end = start;
    while (
      end < start + 40 &&
      end < this.#bytes.length &&
      !isBlank(this.#bytes[end]) &&
      !isLineEnd(this.#bytes[end])
    )
      end++;
    return new TextDecoder().decode(this.#bytes.subarray(start, end));
  }

  #isAtEnd(): boolean {
    const next = this.#bytes[this.#at];
    return next === undefined || isBlank(next) || isLineEnd(next);
  }

  #skipBlanks(): void {
    while (isBlank(this.#bytes[this.#at])) this.#at++;
  }

  #nextLine(): void {
    const end = this.#bytes.indexOf(newline, this.#at);
    this.#at = end < 0 ? this.#bytes.length : end + 1;
  }

  #fail(what: string): never {
    throw new FileError(
      this.#file,
      `${what} (line ${this.#line}); it may be damaged: export it again.`,
      {reason: 'damaged'},
    );
  }
}

const isDigit = (byte: number | undefined): boolean =>
  byte !== undefined && byte >= zero && byte <= nine;
const isBlank = (byte: number | undefined): boolean => byte === space || byte === tab;
const isLineEnd = (byte: number | undefined): boolean => byte === newline || byte === carriage;
