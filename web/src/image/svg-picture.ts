/** SVG as an image. */

/** An image as a value for `href`: SVG text becomes a data URL, anything else is unchanged. */
export const imageHref = (image: string): string =>
  image.trimStart().startsWith('<') ? `data:image/svg+xml,${encodeURIComponent(image)}` : image;

/**
 * Returns whether an SVG refers to external images, which are not loaded in an image and appear
 * broken.
 */
export function hasOutsidePictures(svg: string): boolean {
  // missing external fonts are replaced, so they do not count
  const text = svg
    .replaceAll(/<!--[^]*?-->/g, '')
    .replaceAll(/@font-face\s*\{[^}]*\}|@import[^;]*;/gi, '');
  const named =
    /<(?:\w+:)?(?:image|feImage|use)\b[^>]*?\s(?:\w+:)?href\s*=\s*(["'])\s*(?!#|data:|\1)/i;
  const painted = /url\(\s*(?:["']|&quot;)?(?!["'#\s]|&quot;|data:)/i;
  return named.test(text) || painted.test(text);
}
