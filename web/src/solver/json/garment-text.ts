import {scan, type JsonSink} from './scan.js';

/**
 * A garment file as seamwise-garment/1. Assumed properties (units, notation of curves) are stated;
 * everything else stays as written, including unknown fields and all digits. Applied to its own
 * output, it gives the same bytes.
 * @param file JSON text that the module has read as a garment
 */
export function garmentText(file: string): string {
  const document = membersOf(file.replace(/^\uFEFF/, ''), '\n ');
  const properties = membersOf(document.get('properties') ?? 'null', '\n  ');
  state(properties, 'units_in_meter', '100');
  state(properties, 'curvature_coords', '"relative"');
  document.delete('format');
  document.set('properties', objectOf(properties, '\n '));
  const inOrder = new Map([['format', '"seamwise-garment/1"'], ...document]);
  return `${objectOf(inOrder, '\n')}\n`;
}

function state(members: Map<string, string>, name: string, assumed: string): void {
  if ((members.get(name) ?? 'null') === 'null') members.set(name, assumed);
}

/** Text of an object. @param newLine line break and indent of its last line */
function objectOf(members: ReadonlyMap<string, string>, newLine: string): string {
  const lines = Array.from(members, ([name, text]) => `${JSON.stringify(name)}: ${text}`);
  return `{${newLine} ${lines.join(`,${newLine} `)}${newLine}}`;
}

/**
 * Members of an object, each as text.
 * @param newLine line break and indent of the members' lines
 */
function membersOf(text: string, newLine: string): Map<string, string> {
  const printer = new MemberPrinter(newLine);
  scan(text, printer);
  return printer.members;
}

class MemberPrinter implements JsonSink {
  readonly members = new Map<string, string>();
  readonly #newLine: string;
  /** Closing brackets of the open lists and objects. */
  readonly #ends: string[] = [];
  #name = '';
  #text = '';
  #isFirst = true;

  constructor(newLine: string) {
    this.#newLine = newLine;
  }

  word(value: boolean | null): void {
    this.#add(String(value));
  }

  number(_value: number, token: string): void {
    this.#add(token);
  }

  text(value: string): void {
    this.#add(JSON.stringify(value));
  }

  name(name: string): void {
    if (this.#ends.length === 1) this.#name = name;
    else this.#begin(`${JSON.stringify(name)}: `);
  }

  open(isObject: boolean): void {
    if (this.#ends.at(-1) === ']') this.#begin('');
    if (this.#ends.length > 0) this.#text += isObject ? '{' : '[';
    this.#ends.push(isObject ? '}' : ']');
    this.#isFirst = true;
  }

  close(): void {
    const end = this.#ends.pop();
    if (end === undefined || this.#ends.length === 0) return;
    if (!this.#isFirst) this.#text += this.#line();
    this.#text += end;
    this.#isFirst = false;
    this.#keep();
  }

  #add(text: string): void {
    if (this.#ends.at(-1) === ']') this.#begin('');
    this.#text += text;
    this.#keep();
  }

  /** Begins the line of an item in the open list or object. */
  #begin(text: string): void {
    this.#text += `${this.#isFirst ? '' : ','}${this.#line()}${text}`;
    this.#isFirst = false;
  }

  #line(): string {
    return this.#newLine + ' '.repeat(Math.max(0, this.#ends.length - 1));
  }

  #keep(): void {
    if (this.#ends.length !== 1) return;
    this.members.set(this.#name, this.#text);
    this.#text = '';
  }
}
