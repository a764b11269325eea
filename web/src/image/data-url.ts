/** Converts files to `data:` URLs and back. */

/**
 * Decodes a `data:` URL.
 * @throws {Error} if the URL is malformed
 */
export function blobOf(url: string): Blob {
  const comma = url.indexOf(',');
  const head = url.slice('data:'.length, comma);
  const body = url.slice(comma + 1);
  const [type = ''] = head.split(';');
  if (!head.endsWith(';base64')) return new Blob([decodeURIComponent(body)], {type});
  return new Blob([Uint8Array.from(atob(body), (letter) => letter.charCodeAt(0))], {type});
}

/**
 * Encodes a file as a `data:` URL.
 * @throws {Error} if the file is no longer readable
 */
export const dataUrlOf = (blob: Blob): Promise<string> =>
  new Promise((resolve, reject) => {
    const reader = new FileReader();
    reader.onload = () => {
      resolve(reader.result as string); // readAsDataURL results in a string
    };
    reader.onerror = () => {
      reject(new Error(reader.error?.message));
    };
    reader.readAsDataURL(blob);
  });
