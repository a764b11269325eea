/** Text made small enough to travel in an address: deflated, in letters that addresses allow. */

/** What is no such text, or unfolds to more than it may. */
export class Inflated extends Error {
  override readonly name = 'Inflated';
}

export async function deflated(text: string): Promise<string> {
  const stream = new Blob([text]).stream().pipeThrough(new CompressionStream('deflate-raw'));
  return base64url(new Uint8Array(await new Response(stream).arrayBuffer()));
}

/**
 * The inverse of `deflated`. A few kilobytes may unfold to gigabytes: that is stopped on the way.
 * @param most [bytes]
 * @throws {Inflated}
 */
export async function inflated(letters: string, most: number): Promise<string> {
  const stream = new Blob([bytesOf(letters)])
    .stream()
    .pipeThrough(new DecompressionStream('deflate-raw'));
  const decoder = new TextDecoder('utf-8', {fatal: true});
  const reader = stream.getReader();
  let text = '';
  let length = 0;
  try {
    for (;;) {
      const {done, value} = await reader.read();
      if (done) return text + decoder.decode();
      length += value.length;
      if (length > most) throw new Inflated(`more than ${most} bytes`);
      text += decoder.decode(value, {stream: true});
    }
  } catch (cause) {
    throw new Inflated('not a deflated text', {cause});
  } finally {
    // whatever is still to come is not wanted, and may be broken
    await reader.cancel().catch(() => undefined);
  }
}

export function base64url(bytes: Uint8Array): string {
  const letters = Array.from(bytes, (byte) => String.fromCodePoint(byte)).join('');
  return btoa(letters).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
}

/** @throws {Inflated} for what is no base64url */
export function bytesOf(letters: string): Uint8Array<ArrayBuffer> {
  if (!/^[\w-]*$/.test(letters) || letters.length % 4 === 1) throw new Inflated('no base64url');
  const bytes = atob(letters.replaceAll('-', '+').replaceAll('_', '/'));
  return Uint8Array.from(bytes, (byte) => byte.codePointAt(0) ?? 0);
}
