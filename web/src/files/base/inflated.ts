type Bytes = Uint8Array<ArrayBuffer>;

/**
 * The inflated data of an image, read no further than its pixels need.
 * @throws {RangeError} if there is less or more
 */
export async function inflated(data: Bytes, size: number): Promise<Bytes> {
  const through = new Blob([data]).stream().pipeThrough(new DecompressionStream('deflate'));
  const reader = through.getReader();
  const out = new Uint8Array(size);
  let at = 0;
  for (;;) {
    const {done, value} = await reader.read();
    if (done) break;
    if (at + value.length > size) {
      await reader.cancel();
      throw new RangeError('more data than pixels');
    }
    out.set(value, at);
    at += value.length;
  }
  if (at < size) throw new RangeError('cut off');
  return out;
}
