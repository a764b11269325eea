import {deflateSync} from 'node:zlib';

const bytesOf = (value: number): Buffer => {
  const bytes = Buffer.alloc(4);
  bytes.writeUInt32BE(value);
  return bytes;
};

const chunk = (type: string, data: Uint8Array): Buffer => {
  const body = Buffer.concat([Buffer.from(type, 'latin1'), data]);
  return Buffer.concat([bytesOf(data.length), body, bytesOf(crc(body))]);
};

interface RawPng {
  readonly width: number;
  readonly height: number;
  /** Bits per colour. Default 8. */
  readonly bits?: number;
  /** Colour type: 0 grey, 2 RGB, 3 palette. */
  readonly kind: number;
  /** Compressed rows with their filters. */
  readonly data: Uint8Array;
  readonly palette?: Uint8Array;
}

/** A PNG file of given data. */
export const asPng = ({width, height, bits = 8, kind, data, palette}: RawPng): Buffer =>
  Buffer.concat([
    Buffer.from('\u0089PNG\r\n\u001a\n', 'latin1'),
    chunk('IHDR', Buffer.concat([bytesOf(width), bytesOf(height), Buffer.of(bits, kind, 0, 0, 0)])),
    ...(palette?.length ? [chunk('PLTE', palette)] : []),
    chunk('IDAT', data),
    chunk('IEND', Buffer.alloc(0)),
  ]);

/** A PNG of one colour and any size, in a few kilobytes. */
export function png(width: number, height: number, content = true): Buffer {
  const rows = content ? Buffer.alloc((1 + Math.ceil(width / 8)) * height) : Buffer.alloc(1);
  return asPng({width, height, bits: 1, kind: 0, data: deflateSync(rows, {level: 9})});
}

function crc(bytes: Buffer): number {
  let sum = 0xffffffff;
  for (const byte of bytes) {
    sum ^= byte;
    for (let k = 0; k < 8; k++) sum = sum & 1 ? (sum >>> 1) ^ 0xedb88320 : sum >>> 1;
  }
  return (sum ^ 0xffffffff) >>> 0;
}
