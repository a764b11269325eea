/**
 * Reads and sets the size of an SVG in its text, since a parser would apply the page's content
 * security policy to its styles.
 */

const rootTag = /<(?:\w+:)?svg\b(?:[^>"']|"[^"]*"|'[^']*')*>/i;

/** Size of an SVG that states none. [px] */
const unsaid = 100;

const bare = (text: string): string => text.replaceAll(/<!--[^]*?-->/g, '');

/** An attribute of the root element; undefined if it is missing. */
export function rootAttribute(text: string, name: string): string | undefined {
  const tag = rootTag.exec(bare(text))?.[0] ?? '';
  return new RegExp(`\\s${name}\\s*=\\s*["']([^"']*)["']`).exec(tag)?.[1];
}

/**
 * The SVG with width and height in pixels from its view box, since some browsers do not draw images
 * without them.
 */
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
