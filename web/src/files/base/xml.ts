/**
 * A small XML parser, since Node has none. It neither fetches nor expands anything that a file
 * declares.
 */
import {FileError} from '../../model/base/versioned-file.js';

export interface XmlElement {
  /** Local name without the prefix. */
  readonly name: string;
  /** Keyed by qualified name, with the prefix. */
  readonly attributes: ReadonlyMap<string, string>;
  readonly children: readonly (XmlElement | string)[];
}

export interface XmlDocument {
  readonly root: XmlElement;
  /** Comments before and inside the root; programs write their names there. */
  readonly comments: readonly string[];
}

/** Limits far above those of drawings, since walking the tree is recursive. */
const deepest = 64;
const mostElements = 60_000;

const entities: Readonly<Record<string, string>> = {
  ...{amp: '&', lt: '<', gt: '>', quot: '"', apos: "'"},
};

/**
 * Parses a document.
 * @throws {FileError} if it is malformed, too deep or too large, or uses its own entities
 */
export function readXml(text: string, file: string): XmlDocument {
  return new Reader(text, file).read();
}

interface Open {
  readonly name: string;
  readonly attributes: ReadonlyMap<string, string>;
  readonly children: (XmlElement | string)[];
}

const withoutPrefix = (name: string): string => name.slice(name.indexOf(':') + 1);

class Reader {
  readonly #text: string;
  readonly #file: string;
  readonly #open: Open[] = [];
  readonly #comments: string[] = [];
  #root: XmlElement | undefined;
  #at = 0;
  #elements = 0;

  constructor(text: string, file: string) {
    this.#text = text;
    this.#file = file;
  }

  read(): XmlDocument {
    const text = this.#text;
    while (this.#at < text.length) {
      const next = text.indexOf('<', this.#at);
      this.#words(text.slice(this.#at, next < 0 ? text.length : next));
      if (next < 0) break;
      this.#at = next;
      this.#markup();
    }
    const unclosed = this.#open.at(-1);
    if (unclosed || !this.#root) {
      return this.#fail(unclosed ? `<${unclosed.name}> is never closed` : 'it has no element');
    }
    return {root: this.#root, comments: this.#comments};
  }

  #markup(): void {
    const text = this.#text;
    if (text.startsWith('<!--', this.#at)) {
      this.#comments.push(this.#upTo('<!--', '-->'));
    } else if (text.startsWith('<![CDATA[', this.#at)) {
      this.#open.at(-1)?.children.push(this.#upTo('<![CDATA[', ']]>'));
    } else if (text.startsWith('<?', this.#at)) {
      this.#upTo('<?', '?>');
    } else if (text.startsWith('<!', this.#at)) {
      this.#declaration();
    } else if (text.startsWith('</', this.#at)) {
      this.#close(this.#upTo('</', '>').trim());
    } else {
      this.#tag();
    }
  }

  /** The text between two markers; reading continues after the second. */
  #upTo(from: string, to: string): string {
    const start = this.#at + from.length;
    const end = this.#text.indexOf(to, start);
    if (end < 0) this.#fail(`'${from}' is never closed`);
    this.#at = end + to.length;
    return this.#text.slice(start, end);
  }

  /** Skips a document type without its declarations. */
  #declaration(): void {
    const whole = /<!(?:[^<>"'[]|"[^"]*"|'[^']*')*(?:\[(?:[^\]"']|"[^"]*"|'[^']*')*\]\s*)?>/y;
    whole.lastIndex = this.#at;
    if (!whole.test(this.#text)) this.#fail("'<!' is never closed");
    this.#at = whole.lastIndex;
  }

  #words(raw: string): void {
    const parent = this.#open.at(-1);
    if (parent && raw.trim() !== '') parent.children.push(this.#decoded(raw));
  }

  #tag(): void {
    const start = /<([^\s/>"'=<]+)/y;
    start.lastIndex = this.#at;
    const name = start.exec(this.#text)?.[1];
    if (name === undefined) return this.#fail("'<' begins nothing");
    if (++this.#elements > mostElements) {
      throw new FileError(
        this.#file,
        `holds more than ${mostElements} elements, as a picture has them and no pattern; delete all but the outlines and their marks.`,
        {reason: 'complex'},
      );
    }
    if (this.#open.length >= deepest) {
      throw new FileError(
        this.#file,
        `has elements that lie in each other more than ${deepest} deep; ungroup them.`,
        {reason: 'complex'},
      );
    }
    const attributes = this.#attributes(start.lastIndex);
    const end = /\s*(\/?)>/y;
    end.lastIndex = this.#at;
    const closes = end.exec(this.#text)?.[1];
    if (closes === undefined) this.#fail(`<${name}> has an attribute that cannot be read`);
    this.#at = end.lastIndex;
    const element: Open = {name: withoutPrefix(name), attributes, children: []};
    const parent = this.#open.at(-1);
    if (!parent && this.#root) this.#fail(`<${name}> stands behind the end`);
    if (parent) parent.children.push(element);
    else this.#root = element;
    if (closes === '') this.#open.push({...element, name});
  }

  #attributes(from: number): ReadonlyMap<string, string> {
    const one = /\s+([^\s=/>"'<]+)\s*=\s*(?:"([^"<]*)"|'([^'<]*)')/y;
    const attributes = new Map<string, string>();
    this.#at = from;
    for (one.lastIndex = from; ; this.#at = one.lastIndex) {
      const [found, name = '', double, single] = one.exec(this.#text) ?? [];
      if (found === undefined) return attributes;
      // skips namespaces, for whose names Illustrator declares entities
      if (!name.startsWith('xmlns')) attributes.set(name, this.#decoded(double ?? single ?? ''));
    }
  }

  #close(name: string): void {
    const open = this.#open.pop();
    if (open?.name !== name) {
      this.#fail(open ? `</${name}> closes <${open.name}>` : `</${name}> closes nothing`);
    }
  }

  #decoded(raw: string): string {
    return raw.includes('&')
      ? raw.replaceAll(/&([^;\s&]*);?/g, (_, name: string) => this.#entity(name))
      : raw;
  }

  #entity(name: string): string {
    const [, hex, decimal] = /^#(?:x([\da-f]{1,6})|(\d{1,7}))$/i.exec(name) ?? [];
    const code = hex === undefined ? Number(decimal ?? NaN) : parseInt(hex, 16);
    if (code > 0 && code <= 0x10ffff) return String.fromCodePoint(code);
    const known = Object.hasOwn(entities, name) ? entities[name] : undefined;
    if (known !== undefined) return known;
    throw new FileError(
      this.#file,
      `uses the entity '&${name};', and entities that a file declares are not read; save it as plain SVG.`,
    );
  }

  #fail(what: string): never {
    const line = this.#text.slice(0, this.#at).split('\n').length;
    throw new FileError(
      this.#file,
      `is damaged near line ${line}, or cut short: ${what}; export it again.`,
      {reason: 'damaged'},
    );
  }
}
