/** Returns whether two images are the same byte for byte; false if one cannot be read. */
export async function areSame(one: Blob, other: Blob): Promise<boolean> {
  if (one.size !== other.size) return false;
  try {
    const [a, b] = await Promise.all([one.arrayBuffer(), other.arrayBuffer()]);
    const [first, second] = [new Uint8Array(a), new Uint8Array(b)];
    for (let k = 0; k < first.length; k++) if (first[k] !== second[k]) return false;
    return true;
  } catch {
    return false;
  }
}
