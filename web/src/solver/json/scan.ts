/**
 * Scans JSON value by value, as it is written. `JSON.parse` is unsuitable for files: it moves
 * members named by numbers to the front, takes the last of two members with one name, and words the
 * place of an error differently in every browser.
 */

/** Receives the values of a text in their order. */
export interface JsonSink {
  /** `null`, `true` or `false`. */
  word(value: boolean | null): void;
  /** @param token text of the number */
  number(value: number, token: string): void;
  text(value: string): void;
  open(isObject: boolean): void;
  /** Receives the name of the next value. */
  name(name: string): void;
  close(): void;
}

type JsonDefect = 'unexpected' | 'noNumber' | 'overflow' | 'incomplete';

/** Place and kind of an error in a text. */
export interface JsonBreak {
  readonly defect: JsonDefect;
  /** Number of UTF-16 units that were read; at the end of the text, one more than it has. */
  readonly position: number;
}

const [tab, newline, carriageReturn, space, quote, comma, point] = [9, 10, 13, 32, 34, 44, 46];
const [plus, minus, colon, letterE, letterU, backslash] = [43, 45, 58, 101, 117, 92];
const [openList, closeList, openObject, closeObject] = [91, 93, 123, 125];
const words = new Map<number, readonly [word: string, value: boolean | null]>([
  [116, ['true', true]],
  [102, ['false', false]],
  [110, ['null', null]],
]);
const escapes = new Set([34, 92, 47, 98, 102, 110, 114, 116]);

const isDigit = (code: number): boolean => code >= 48 && code <= 57;
const isHigh = (code: number): boolean => code >= 0xd800 && code < 0xdc00;
const isLow = (code: number): boolean => code >= 0xdc00 && code < 0xe000;

/**
 * Scans a text and passes its values to the sink. Returns null for valid JSON, or if there are more
 * than `mostValues` values. Depth of nesting and repeated names are not checked.
 */
export function scan(text: string, sink: JsonSink, mostValues = Infinity): JsonBreak | null {
  try {
    new Scanner(text, sink).run(mostValues);
    return null;
  } catch (error) {
    if (!(error instanceof Broken)) throw error;
    const {position, isOverflow} = error;
    // the token may start a letter or two before the place of the error
    const near = text.substring(position - 9, Math.max(position, 9) + 9);
    let defect: JsonDefect = position > text.length ? 'incomplete' : 'unexpected';
    if (/NaN|nan|[Ii]nf/.test(near)) defect = 'noNumber';
    return {defect: isOverflow ? 'overflow' : defect, position};
  }
}

/** Error that is used only within this file. */
class Broken extends Error {
  readonly position: number;
  readonly isOverflow: boolean;

  constructor(position: number, isOverflow = false) {
    super();
    this.position = position;
    this.isOverflow = isOverflow;
  }
}

class Scanner {
  readonly #text: string;
  readonly #sink: JsonSink;
  #at = 0;

  constructor(text: string, sink: JsonSink) {
    this.#text = text;
    this.#sink = sink;
  }

  run(mostValues: number): void {
    const around: boolean[] = []; // for each open list or object: true for an object
    for (let values = 0; values <= mostValues; values++) {
      if (this.#begin(around)) continue;
      let isObject = around.at(-1);
      while (isObject !== undefined && this.#next() === (isObject ? closeObject : closeList)) {
        this.#close(around);
        isObject = around.at(-1);
      }
      if (isObject === undefined) {
        if (!Number.isNaN(this.#next())) this.#unexpected();
        return;
      }
      if (this.#next() !== comma) this.#unexpected();
      this.#at++;
      if (isObject) this.#name();
    }
  }

  /** Reads a value. Of a non-empty list or object it reads only the beginning, and returns true. */
  #begin(around: boolean[]): boolean {
    const code = this.#next();
    if (code !== openList && code !== openObject) {
      this.#scalar(code);
      return false;
    }
    const isObject = code === openObject;
    this.#at++;
    this.#sink.open(isObject);
    around.push(isObject);
    if (this.#next() === (isObject ? closeObject : closeList)) {
      this.#close(around);
      return false;
    }
    if (isObject) this.#name();
    return true;
  }

  #close(around: boolean[]): void {
    this.#at++;
    around.pop();
    this.#sink.close();
  }

  #name(): void {
    if (this.#next() !== quote) this.#unexpected();
    this.#sink.name(this.#string());
    if (this.#next() !== colon) this.#unexpected();
    this.#at++;
  }

  #scalar(code: number): void {
    const word = words.get(code);
    if (code === quote) {
      this.#sink.text(this.#string());
    } else if (code === minus || isDigit(code)) {
      const token = this.#number();
      const value = Number(token);
      if (!Number.isFinite(value)) throw new Broken(this.#at, true);
      this.#sink.number(token === '-0' ? 0 : value, token); // no whole number is -0
    } else if (word) {
      this.#word(word[0]);
      this.#sink.word(word[1]);
    } else {
      throw new Broken(this.#at + 1);
    }
  }

  /**
   * Rejects an unexpected token. It is read first, because an error within the token takes
   * precedence.
   */
  #unexpected(): never {
    const code = this.#next();
    const word = words.get(code)?.[0];
    if (code === quote) this.#string();
    else if (code === minus || isDigit(code)) this.#number();
    else if (word !== undefined) this.#word(word);
    else this.#at++;
    throw new Broken(this.#at);
  }

  /** The first unit of the next token; NaN at the end. */
  #next(): number {
    for (;;) {
      const code = this.#text.charCodeAt(this.#at);
      if (code !== space && code !== newline && code !== carriageReturn && code !== tab)
        return code;
      this.#at++;
    }
  }

  #word(word: string): void {
    for (let k = 1; k < word.length; k++) {
      if (this.#text[this.#at + k] !== word[k]) throw new Broken(this.#at + k + 1);
    }
    this.#at += word.length;
  }

  #number(): string {
    const text = this.#text;
    let k = this.#at;
    const digits = (): void => {
      if (!isDigit(text.charCodeAt(k))) throw new Broken(k + 1);
      while (isDigit(text.charCodeAt(k))) k++;
    };
    if (text.charCodeAt(k) === minus) k++;
    if (text[k] === '0') k++;
    else digits();
    if (text.charCodeAt(k) === point) {
      k++;
      digits();
    }
    if ((text.charCodeAt(k) | 32) === letterE) {
      k++;
      const sign = text.charCodeAt(k);
      if (sign === plus || sign === minus) k++;
      digits();
    }
    const token = text.slice(this.#at, k);
    this.#at = k;
    return token;
  }

  #string(): string {
    const text = this.#text;
    const start = this.#at;
    let isPlain = true;
    for (let k = start + 1; ; k++) {
      const code = text.charCodeAt(k);
      if (code === quote) {
        this.#at = k + 1;
        return isPlain
          ? text.slice(start + 1, k)
          : (JSON.parse(text.slice(start, k + 1)) as string);
      }
      if (code === backslash) {
        isPlain = false;
        k = this.#escape(k + 1);
      } else if (isHigh(code) && isLow(text.charCodeAt(k + 1))) {
        k++;
      } else if (!(code >= space) || isHigh(code) || isLow(code)) {
        throw new Broken(k + 1);
      }
    }
  }

  /** Reads the escape after a backslash. @returns position of its last unit */
  #escape(at: number): number {
    const code = this.#text.charCodeAt(at);
    if (escapes.has(code)) return at;
    if (code !== letterU) throw new Broken(at + 1);
    const first = this.#hex(at + 1);
    if (isLow(first)) throw new Broken(at + 5);
    if (!isHigh(first)) return at + 4;
    if (this.#text.charCodeAt(at + 5) !== backslash) throw new Broken(at + 6);
    if (this.#text.charCodeAt(at + 6) !== letterU) throw new Broken(at + 7);
    if (!isLow(this.#hex(at + 7))) throw new Broken(at + 11);
    return at + 10;
  }

  #hex(at: number): number {
    for (let k = at; k < at + 4; k++) {
      if (!/[0-9a-fA-F]/.test(this.#text.charAt(k))) throw new Broken(k + 1);
    }
    return parseInt(this.#text.slice(at, at + 4), 16);
  }
}
