/** An SVG as the picture of a print: all of it in the file, and of a size of its own. */

const svgNamespace = 'http://www.w3.org/2000/svg';

/** Of an SVG that says nothing about its size. [px] */
const unsaid = 100;

/** Undefined for what is no SVG, or not well-formed. */
export function parsedSvg(text: string): Element | undefined {
  const root = new DOMParser().parseFromString(text, 'image/svg+xml').documentElement;
  const isDamaged = root.localName === 'parsererror' || root.querySelector('parsererror') !== null;
  return root.namespaceURI === svgNamespace && root.localName === 'svg' && !isDamaged
    ? root
    : undefined;
}

/** With a width and a height, which some browsers do not show a picture without; in pixels, from its view box. */
export function sizedSvg(root: Element, text: string): string {
  const isSized = ['width', 'height'].every((name) => {
    const value = root.getAttribute(name) ?? '';
    return /^\s*[\d.]/.test(value) && !value.includes('%');
  });
  if (isSized) return text;
  const box = (root.getAttribute('viewBox') ?? '')
    .trim()
    .split(/[\s,]+/)
    .map(Number);
  const [width, height] = [box[2] ?? 0, box[3] ?? 0];
  const isBoxed = width > 0 && height > 0;
  root.setAttribute('width', String(isBoxed ? width : unsaid));
  root.setAttribute('height', String(isBoxed ? height : unsaid));
  return new XMLSerializer().serializeToString(root);
}
