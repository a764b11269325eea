/** How large a picture is, from the first bytes of its file: before a browser makes pixels of it. */

export interface PictureSize {
  readonly width: number;
  readonly height: number;
}

/** Undefined for what is no PNG, JPEG, WebP or GIF. */
export function pictureSize(bytes: Uint8Array): PictureSize | undefined {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  try {
    if (view.getUint32(0) === 0x89504e47) {
      return {width: view.getUint32(16), height: view.getUint32(20)};
    }
    if (view.getUint32(0) === 0x47494638) {
      return {width: view.getUint16(6, true), height: view.getUint16(8, true)};
    }
    if (view.getUint32(0) === 0x52494646 && view.getUint32(8) === 0x57454250) return webp(view);
    return view.getUint16(0) === 0xffd8 ? jpeg(view) : undefined;
  } catch (error) {
    if (error instanceof RangeError) return undefined; // the file ends too early
    throw error;
  }
}

/** The first frame's segment says it; those before it are passed over. */
function jpeg(view: DataView): PictureSize | undefined {
  for (let at = 2; ; at += 2 + view.getUint16(at + 2)) {
    const marker = view.getUint16(at);
    if (marker < 0xff00) return undefined;
    const isFrame = marker >= 0xffc0 && marker <= 0xffcf;
    if (isFrame && ![0xffc4, 0xffc8, 0xffcc].includes(marker)) {
      return {width: view.getUint16(at + 7), height: view.getUint16(at + 5)};
    }
  }
}

function webp(view: DataView): PictureSize | undefined {
  switch (view.getUint32(12)) {
    case 0x56503820: // lossy
      return {width: view.getUint16(26, true) & 0x3fff, height: view.getUint16(28, true) & 0x3fff};
    case 0x5650384c: {
      // lossless: 14 bits each
      const bits = view.getUint32(21, true);
      return {width: (bits & 0x3fff) + 1, height: ((bits >> 14) & 0x3fff) + 1};
    }
    case 0x56503858: {
      const side = (at: number): number => (view.getUint32(at, true) & 0xffffff) + 1;
      return {width: side(24), height: side(27)};
    }
    default:
      return undefined;
  }
}
