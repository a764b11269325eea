/** SVG as a picture. */

/** A picture as something `href` can name: SVG text becomes a data URL, anything else stays. */
export const imageHref = (image: string): string =>
  image.trimStart().startsWith('<') ? `data:image/svg+xml,${encodeURIComponent(image)}` : image;

/** Whether an SVG takes in pictures from elsewhere: as an image it may not, and shows the sign of a broken one instead. */
export function hasOutsidePictures(svg: string): boolean {
  // in the place of fonts from elsewhere, others are shown
  const text = svg
    .replaceAll(/<!--[^]*?-->/g, '')
    .replaceAll(/@font-face\s*\{[^}]*\}|@import[^;]*;/gi, '');
  const named =
    /<(?:\w+:)?(?:image|feImage|use)\b[^>]*?\s(?:\w+:)?href\s*=\s*(["'])\s*(?!#|data:|\1)/i;
  const painted = /url\(\s*(?:["']|&quot;)?(?!["'#\s]|&quot;|data:)/i;
  return named.test(text) || painted.test(text);
}
