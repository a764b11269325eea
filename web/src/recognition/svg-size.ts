/** The size that an SVG gives itself, read from its text: a parser would hold its styles against the page's policy. */

const rootTag = /<(?:\w+:)?svg\b(?:[^>"']|"[^"]*"|'[^']*')*>/i;

/** Of an SVG that says nothing about its size. [px] */
const unsaid = 100;

const bare = (text: string): string => text.replaceAll(/<!--[^]*?-->/g, '');

/** An attribute of the outermost element; undefined where it has none. */
export function rootAttribute(text: string, name: string): string | undefined {
  const tag = rootTag.exec(bare(text))?.[0] ?? '';
  return new RegExp(`\\s${name}\\s*=\\s*["']([^"']*)["']`).exec(tag)?.[1];
}

/** With a width and a height, which some browsers do not draw a picture without: in pixels, from its view box. */
export function sizedSvg(text: string): string {
  const isSized = ['width', 'height'].every((name) =>
    /^\s*[\d.]+\s*([a-z]+\s*)?$/i.test(rootAttribute(text, name) ?? ''),
  );
  if (isSized) return text;
  const box = (rootAttribute(text, 'viewBox') ?? '')
    .trim()
    .split(/[\s,]+/)
    .map(Number);
  const [width, height] = [box[2] ?? 0, box[3] ?? 0];
  const [across, up] = width > 0 && height > 0 ? [width, height] : [unsaid, unsaid];
  return bare(text).replace(rootTag, (tag) =>
    tag
      .replaceAll(/\s(?:width|height)\s*=\s*(?:"[^"]*"|'[^']*')/g, '')
      .replace(/svg\b/i, (name) => `${name} width="${across}" height="${up}"`),
  );
}
