/** DXF as text: pairs of a group code and a value, one line each. Code 0 begins a group. */
import type {Point} from '../../model/geometry/vectors.js';
import {FileError} from '../../model/base/versioned-file.js';

/** Greatest coordinate of a pattern, in any unit. */
const greatest = 1e7;

/** Greatest number of tags in a group. */
const mostTags = 200_000;

interface Tag {
  readonly code: number;
  readonly value: string;
  readonly line: number;
}

/** The tags from one code 0 to the next. */
export class Group {
  readonly type: string;
  readonly tags: Tag[] = [];
  readonly #begin: Tag;
  readonly #name: string;

  constructor(begin: Tag, name: string) {
    this.#begin = begin;
    this.#name = name;
    this.type = begin.value.trim().toUpperCase();
  }

  /** The last text of a code; '' if there is none. */
  text(code: number): string {
    return this.tags.findLast((tag) => tag.code === code)?.value ?? '';
  }

  /**
   * The first number of a code, or a default.
   * @throws {FileError} if the value is no number or too large
   */
  number(code: number, otherwise?: number): number {
    const tag = this.tags.find((one) => one.code === code);
    if (tag) return this.#numberIn(tag);
    if (otherwise !== undefined) return otherwise;
    throw damaged(this.#name, this.#begin.line, `, where a ${this.type} lacks a number`);
  }

  numbers(code: number): number[] {
    return this.tags.filter((tag) => tag.code === code).map((tag) => this.#numberIn(tag));
  }

  point(code: number): Point {
    return [this.number(code), this.number(code + 10)];
  }

  /** Every point of a code, with the bulge that follows it. */
  vertices(code = 10): Vertex[] {
    const vertices: Vertex[] = [];
    for (const tag of this.tags) {
      const last = vertices.at(-1);
      if (tag.code === code) vertices.push({at: [this.#numberIn(tag), 0], bulge: 0});
      else if (!last) continue;
      else if (tag.code === code + 10) last.at = [last.at[0], this.#numberIn(tag)];
      else if (tag.code === 42) last.bulge = this.#numberIn(tag);
    }
    return vertices;
  }

  /**
   * An error at this group.
   * @param complaint predicate of the error sentence, without its full stop
   */
  error(complaint: string): FileError {
    return damaged(this.#name, this.#begin.line, `, where a ${this.type} ${complaint}`);
  }

  #numberIn({value, line}: Tag): number {
    const text = value.trim();
    const number = text === '' ? NaN : Number(text.replace(',', '.'));
    if (Math.abs(number) <= greatest) return number;
    throw damaged(this.#name, line, `, which has ${quoted(value)} where a length belongs`);
  }
}

export interface Vertex {
  at: Point;
  bulge: number;
}

/**
 * The groups of a file; tags before the first are skipped.
 * @param name file name for messages
 * @throws {FileError} for invalid pairs
 */
export function* groupsOf(text: string, name: string): Generator<Group> {
  // programs on old Macintoshes end lines with CR only
  const lines = linesOf(text.includes('\n') ? text : text.replaceAll('\r', '\n'));
  let group: Group | undefined;
  let number = 0;
  for (;;) {
    const line = ++number;
    const first = lines.next();
    if (first.done) break;
    const code = first.value.trim() === '' ? NaN : Number(first.value);
    const second = lines.next();
    if (second.done && first.value.trim() === '') break; // an empty last line
    if (!Number.isInteger(code)) {
      throw damaged(name, line, `, which has ${quoted(first.value)} where a whole number belongs`);
    }
    if (second.done) throw damaged(name, line, ', where it ends too early');
    number++;
    const tag = {code, value: second.value, line: number};
    if (code !== 0) {
      group?.tags.push(tag);
      if (group && group.tags.length > mostTags) throw group.error('has no end');
      continue;
    }
    if (group) yield group;
    group = new Group(tag, name);
    if (group.type === 'EOF') break;
  }
  if (group) yield group;
}

function* linesOf(text: string): Generator<string, undefined> {
  for (let at = 0; at < text.length;) {
    const found = text.indexOf('\n', at);
    const end = found < 0 ? text.length : found;
    const isReturn = end > at && text.charCodeAt(end - 1) === 13;
    yield text.slice(at, isReturn ? end - 1 : end);
    at = end + 1;
  }
}

const damaged = (name: string, line: number, what: string): FileError =>
  new FileError(name, `is damaged near line ${line}${what}; export it again.`, {reason: 'damaged'});

const quoted = (text: string): string => `'${text.trim().slice(0, 24)}'`;
