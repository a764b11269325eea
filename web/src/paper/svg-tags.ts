/** The elements of an SVG, as far as pictures of prints have them: tags and attributes, in the order of the file. */

export interface SvgElement {
  readonly name: string;
  readonly attributes: ReadonlyMap<string, string>;
  readonly children: SvgElement[];
}

const token =
  /<!--[^]*?-->|<\?[^]*?\?>|<!\[CDATA\[[^]*?\]\]>|<!DOCTYPE[^>[]*>|<(\/?)([\w:.-]+)((?:[^>"']|"[^"]*"|'[^']*')*?)(\/?)>/gi;
const attribute = /([\w:.-]+)\s*=\s*(?:"([^"]*)"|'([^']*)')/g;

/** Declarations of `style` count as attributes, which they outrank. */
function attributesOf(text: string): ReadonlyMap<string, string> {
  const found = new Map<string, string>();
  for (const [, name = '', double, single] of text.matchAll(attribute)) {
    found.set(name.replace(/^xlink:/, ''), (double ?? single ?? '').trim());
  }
  for (const declaration of (found.get('style') ?? '').split(';')) {
    const colon = declaration.indexOf(':');
    if (colon > 0)
      found.set(declaration.slice(0, colon).trim(), declaration.slice(colon + 1).trim());
  }
  return found;
}

/** The outermost element; undefined where the text is no well-formed SVG. */
export function readTags(text: string): SvgElement | undefined {
  const open: SvgElement[] = [{name: '', attributes: new Map(), children: []}];
  for (const [, isEnd, name, rest = '', isEmpty] of text.matchAll(token)) {
    if (name === undefined) continue;
    if (isEnd) {
      if (open.length < 2 || open.pop()?.name !== name) return undefined;
      continue;
    }
    const element = {name, attributes: attributesOf(rest), children: []};
    open.at(-1)?.children.push(element);
    if (!isEmpty) open.push(element);
  }
  const root = open[0]?.children[0];
  return open.length === 1 && root?.name === 'svg' ? root : undefined;
}
