/** A minimal SVG parser for images of prints: tags and attributes in file order. */

export interface SvgElement {
  readonly name: string;
  readonly attributes: ReadonlyMap<string, string>;
  readonly children: SvgElement[];
}

const token =
  /<!--[^]*?-->|<\?[^]*?\?>|<!\[CDATA\[[^]*?\]\]>|<!DOCTYPE[^>[]*>|<(\/?)([\w:.-]+)((?:[^>"']|"[^"]*"|'[^']*')*?)(\/?)>/gi;
const attribute = /([\w:.-]+)\s*=\s*(?:"([^"]*)"|'([^']*)')/g;

/** Attributes, including the declarations of `style`, which override them. */
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

/** The root element; undefined if the text is no well-formed SVG. */
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
