/** Files as `data:` URLs, and back. */

/** @throws {Error} for what is not well-formed */
export function blobOf(url: string): Blob {
  const comma = url.indexOf(',');
  const head = url.slice('data:'.length, comma);
  const body = url.slice(comma + 1);
  const [type = ''] = head.split(';');
  if (!head.endsWith(';base64')) return new Blob([decodeURIComponent(body)], {type});
  return new Blob([Uint8Array.from(atob(body), (letter) => letter.charCodeAt(0))], {type});
}

/** @throws {Error} when the file cannot be read any more */
export const dataUrlOf = (blob: Blob): Promise<string> =>
  new Promise((resolve, reject) => {
    const reader = new FileReader();
    reader.onload = () => {
      resolve(reader.result as string); // what readAsDataURL gives
    };
    reader.onerror = () => {
      reject(new Error(reader.error?.message));
    };
    reader.readAsDataURL(blob);
  });
