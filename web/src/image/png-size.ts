/** Writes the printed size of a PNG into its file. */

/** Bytes of the signature and the header, after which the size is inserted. */
const headerEnd = 33;

const crcTable = Uint32Array.from({length: 256}, (_, byte) => {
  let value = byte;
  for (let bit = 0; bit < 8; bit++) value = value & 1 ? 0xedb88320 ^ (value >>> 1) : value >>> 1;
  return value;
});

function crcOf(bytes: Uint8Array): number {
  let value = 0xffffffff;
  for (const byte of bytes) value = (crcTable[(value ^ byte) & 0xff] ?? 0) ^ (value >>> 8);
  return (value ^ 0xffffffff) >>> 0;
}

/**
 * The PNG with its printed size, as the chunk `pHYs`.
 * @param png a file without that chunk, as encoders write it
 * @param size width and height [cm]
 */
export function withPrintedSize(
  png: Uint8Array,
  {width, height}: {readonly width: number; readonly height: number},
): Uint8Array<ArrayBuffer> {
  const header = new DataView(png.buffer, png.byteOffset, headerEnd);
  const chunk = new Uint8Array(21);
  const view = new DataView(chunk.buffer);
  view.setUint32(0, 9);
  chunk.set(new TextEncoder().encode('pHYs'), 4);
  // pixels per metre
  view.setUint32(8, Math.round((100 * header.getUint32(16)) / width));
  view.setUint32(12, Math.round((100 * header.getUint32(20)) / height));
  chunk[16] = 1;
  view.setUint32(17, crcOf(chunk.subarray(4, 17)));
  const sized = new Uint8Array(png.length + chunk.length);
  sized.set(png.subarray(0, headerEnd));
  sized.set(chunk, headerEnd);
  sized.set(png.subarray(headerEnd), headerEnd + chunk.length);
  return sized;
}
