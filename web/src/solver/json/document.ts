/**
 * JSON documents in the format for the module and back: a head, a node of 16 bytes for every value
 * and every name, and the texts. wasm/src/io/json_value.h describes the nodes;
 * wasm/src/bindings/json_bytes.cpp is the counterpart. Failures of the module become errors.
 */
import type {DocumentLimits, ModuleFailure} from '../module/module.js';
import {scan, type JsonBreak, type JsonSink} from './scan.js';
import {
  drapeReasons,
  failureCode,
  layReasons,
  photoFaults,
  SolverError,
  symmetryReasons,
  type Failure,
} from '../../model/base/failure.js';
import type {ModuleDocument} from '../module/seamwise.mjs';

/** Numbers of kinds and defects in the module. */
const kinds = {null: 0, false: 1, true: 2, number: 3, text: 4, list: 5, object: 6} as const;
const defects = {
  tooLarge: 1,
  empty: 2,
  zeroByte: 3,
  unexpected: 4,
  noNumber: 5,
  overflow: 6,
  incomplete: 7,
} as const;

/** Placeholder for the number of the node after an open list or object. */
const notClosed = 0xffffffff;

const nodeBytes = 16;
/**
 * Limit of remembered texts, because a file of millions of different texts would fill the memory.
 */
const mostKnown = 1000;
const encoder = new TextEncoder();
const decoder = new TextDecoder('utf-8', {ignoreBOM: true});

/**
 * Converts a JSON text for the module; for an invalid text, the valid prefix and the place of the
 * error.
 */
export function documentBytes(file: string, limits: DocumentLimits): Uint8Array {
  const document = new DocumentWriter();
  if (isLarger(file, limits.maxFileBytes)) return document.bytes('tooLarge');
  const text = file.replace(/^\uFEFF/, '');
  if (!/[^ \t\r\n]/.test(text)) return document.bytes('empty');
  const zero = text.indexOf('\0');
  if (zero >= 0) return document.bytes('zeroByte', placeOf(text, zero + 1));
  const broken: JsonBreak | null = scan(text, document, limits.maxValues);
  return broken
    ? document.bytes(broken.defect, placeOf(text, broken.position))
    : document.bytes(null);
}

/** Value of a document from the module. */
export function documentValue(bytes: Uint8Array<ArrayBuffer>): unknown {
  const words = new Uint32Array(bytes.buffer, 0, Math.floor(bytes.length / 4));
  const numbers = new Float64Array(bytes.buffer, 0, Math.floor(bytes.length / 8));
  const texts = bytes.subarray(nodeBytes * (1 + (words[0] ?? 0)));
  const word = (at: number, k: number): number => words[4 * at + k] ?? 0;
  const textAt = (at: number): string =>
    decoder.decode(texts.subarray(word(at, 2), word(at, 2) + word(at, 3)));
  let next = 1; // the head precedes the nodes and has the size of one
  const value = (): unknown => {
    const at = next++;
    const end = word(at, 1) + 1;
    switch (word(at, 0)) {
      case kinds.false:
      case kinds.true:
        return word(at, 0) === kinds.true;
      case kinds.number:
        return numbers[2 * at + 1];
      case kinds.text:
        return textAt(at);
      case kinds.list: {
        const list: unknown[] = [];
        while (next < end) list.push(value());
        return list;
      }
      case kinds.object: {
        const members: (readonly [string, unknown])[] = [];
        while (next < end) members.push([textAt(next++), value()]);
        return Object.fromEntries(members); // a member may be called __proto__
      }
      default:
        return null;
    }
  };
  return value();
}

function isLarger(text: string, bytes: number): boolean {
  const mostOfAUnit = 3;
  if (text.length * mostOfAUnit <= bytes) return false;
  return text.length > bytes || encoder.encode(text).length > bytes;
}

interface TextPlace {
  readonly line: number;
  /** [bytes] */
  readonly column: number;
}

/** Place of the last unit that was read, or the end of the text. */
function placeOf(text: string, position: number): TextPlace {
  const before = text.slice(0, position);
  const lines = before.split('\n');
  const last = lines.at(-1) ?? '';
  const column =
    position > text.length
      ? encoder.encode(last).length
      : encoder.encode(last.slice(0, -1)).length + last.slice(-1).length;
  return {line: lines.length, column: Math.max(1, column)};
}

class DocumentWriter implements JsonSink {
  #words = new Uint32Array(1024);
  #numbers = new Float64Array(this.#words.buffer);
  #texts = new Uint8Array(1024);
  /** Number of nodes, including the head. */
  #count = 1;
  #textBytes = 0;
  /** Places of some of the texts, since names recur often. */
  readonly #known = new Map<string, readonly [start: number, length: number]>();
  /** Open lists and objects, with the number of values in each. */
  readonly #open: {readonly at: number; size: number}[] = [];

  word(value: boolean | null): void {
    this.#value(value === null ? kinds.null : value ? kinds.true : kinds.false);
  }

  number(value: number): void {
    const at = this.#value(kinds.number); // may replace the buffers
    this.#numbers[2 * at + 1] = value;
  }

  text(value: string): void {
    this.#setText(this.#value(kinds.text), value);
  }

  name(name: string): void {
    this.#setText(this.#node(kinds.text), name);
  }

  open(isObject: boolean): void {
    const at = this.#value(isObject ? kinds.object : kinds.list);
    this.#words[4 * at + 1] = notClosed;
    this.#open.push({at, size: 0});
  }

  close(): void {
    const closed = this.#open.pop();
    if (!closed) return;
    this.#words[4 * closed.at + 1] = this.#count - 1;
    this.#words[4 * closed.at + 2] = closed.size;
  }

  bytes(defect: keyof typeof defects | null, place: TextPlace = {line: 0, column: 0}): Uint8Array {
    const head = [this.#count - 1, defect ? defects[defect] : 0, place.line, place.column];
    this.#words.set(head);
    const nodes = nodeBytes * this.#count;
    const bytes = new Uint8Array(nodes + this.#textBytes);
    bytes.set(new Uint8Array(this.#words.buffer, 0, nodes));
    bytes.set(this.#texts.subarray(0, this.#textBytes), nodes);
    return bytes;
  }

  #value(kind: number): number {
    const around = this.#open.at(-1);
    if (around) around.size++;
    return this.#node(kind);
  }

  #node(kind: number): number {
    const at = this.#count++;
    if (4 * this.#count > this.#words.length) {
      const larger = new Uint32Array(2 * this.#words.length);
      larger.set(this.#words);
      this.#words = larger;
      this.#numbers = new Float64Array(larger.buffer);
    }
    this.#words[4 * at] = kind;
    this.#words[4 * at + 1] = at; // number of the next node, not counting the head
    return at;
  }

  #setText(at: number, text: string): void {
    const [start, length] = this.#known.get(text) ?? this.#append(text);
    this.#words[4 * at + 2] = start;
    this.#words[4 * at + 3] = length;
  }

  #append(text: string): readonly [start: number, length: number] {
    const mostOfAUnit = 3;
    const room = this.#textBytes + mostOfAUnit * text.length;
    if (room > this.#texts.length) {
      const larger = new Uint8Array(2 * room);
      larger.set(this.#texts);
      this.#texts = larger;
    }
    const {written} = encoder.encodeInto(text, this.#texts.subarray(this.#textBytes));
    const place = [this.#textBytes, written] as const;
    this.#textBytes += written;
    if (this.#known.size < mostKnown) this.#known.set(text, place);
    return place;
  }
}

/** Value of a document from the module. @throws {SolverError} if there is none */
export function valueOf({document, failure}: ModuleDocument): unknown {
  if (failure) throw toError(failure);
  return documentValue(document);
}

/** Girth [cm], measurement and fitting size in the core's message on a garment that is too small. */
const missingGirth = / by ([\d.]+) cm at the ([a-z ]+?)(?: \(it fits size ([A-Z]+)\))?:/;
/** Least width of the fabric at the end of the core's message. [cm] */
const leastWidth = / at least ([\d.]+) cm wide\.$/;

/** Reads figures from a message: fields for them would make the modules larger. */
function figuresOf(message: string): Pick<Failure, 'lengthCm' | 'measure' | 'fits'> {
  const [, width] = leastWidth.exec(message) ?? [];
  if (width !== undefined) return {lengthCm: Number(width)};
  const [, lacking, measure, fits] = missingGirth.exec(message) ?? [];
  if (lacking === undefined || measure === undefined) return {};
  return {lengthCm: Number(lacking), measure, ...(fits !== undefined && {fits})};
}

export function toError(failure: ModuleFailure): SolverError {
  const {code, message, piece, seam, reason} = failure;
  const known = [...symmetryReasons, ...photoFaults, ...layReasons, ...drapeReasons];
  const why = known.find((one) => one === reason);
  return new SolverError({
    code: failureCode(code),
    message: /[.!?]$/.test(message) ? message : `${message}.`,
    piece: piece < 0 ? null : piece,
    seam: seam < 0 ? null : seam,
    ...(why && {reason: why}),
    ...figuresOf(message),
  });
}
