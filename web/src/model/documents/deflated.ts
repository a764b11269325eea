/** Deflated text in URL-safe letters, small enough for a URL. */

import {partsOf} from '../base/fetched.js';

/** Error for letters that are not a deflated text, or that inflate to more than the limit. */
export class Inflated extends Error {
  override readonly name = 'Inflated';
}

export async function deflated(text: string): Promise<string> {
  const stream = new Blob([text]).stream().pipeThrough(new CompressionStream('deflate-raw'));
  return base64url(new Uint8Array(await new Response(stream).arrayBuffer()));
}

/**
 * The inverse of `deflated`. Inflating stops beyond `most`, because a few kilobytes may expand to
 * gigabytes.
 * @param most limit of the inflated text [bytes]
 * @throws {Inflated}
 */
export async function inflated(letters: string, most: number): Promise<string> {
  const stream = new Blob([bytesOf(letters)])
    .stream()
    .pipeThrough(new DecompressionStream('deflate-raw'));
  try {
    const parts = await partsOf(stream, most);
    if (!parts) throw new Inflated(`more than ${most} bytes`);
    const bytes = await new Blob(parts).arrayBuffer();
    return new TextDecoder('utf-8', {fatal: true}).decode(bytes);
  } catch (cause) {
    throw new Inflated('not a deflated text', {cause});
  }
}

function base64url(bytes: Uint8Array): string {
  const letters = Array.from(bytes, (byte) => String.fromCodePoint(byte)).join('');
  return btoa(letters).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
}

/** Decodes base64url. @throws {Inflated} for letters that are not base64url */
export function bytesOf(letters: string): Uint8Array<ArrayBuffer> {
  if (!/^[\w-]*$/.test(letters) || letters.length % 4 === 1) throw new Inflated('no base64url');
  const bytes = atob(letters.replaceAll('-', '+').replaceAll('_', '/'));
  return Uint8Array.from(bytes, (byte) => byte.codePointAt(0) ?? 0);
}
