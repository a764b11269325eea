/** Decodes image files to upright pixels, and encodes them. */
import {readFile} from 'node:fs/promises';
import {createRequire} from 'node:module';

import {exifTags, type ExifTags} from '../image/exif.js';
import {fileKind, isWhole, type FileKind} from '../image/file-kind.js';
import {upright} from '../image/upright.js';
import type {PhotoPixels} from '../model/print/photo-reading.js';
import {FileError} from '../model/base/versioned-file.js';

/** Upright pixels, and the camera's focal length. */
interface PictureFile {
  readonly pixels: PhotoPixels;
  readonly f35?: number;
}

/** Greatest size of an image file, that of a photo of 60 megapixels. [bytes] */
export const pictureLimit = 40_000_000;

type Decode = (bytes: ArrayBuffer) => Promise<PhotoPixels>;

/** Compiles a decoder module of a package. */
async function compiled(path: string): Promise<WebAssembly.Module> {
  const file = createRequire(import.meta.url).resolve(path);
  return WebAssembly.compile(await readFile(file));
}

const decoders: Readonly<Partial<Record<FileKind, () => Promise<Decode>>>> = {
  jpeg: async () => {
    const {default: decode, init} = await import('@jsquash/jpeg/decode.js');
    await init(await compiled('@jsquash/jpeg/codec/dec/mozjpeg_dec.wasm'));
    return (bytes) => decode(bytes);
  },
  png: async () => {
    const {default: decode, init} = await import('@jsquash/png/decode.js');
    await init(await compiled('@jsquash/png/codec/pkg/squoosh_png_bg.wasm'));
    return (bytes) => decode(bytes);
  },
  webp: async () => {
    const {default: decode, init} = await import('@jsquash/webp/decode.js');
    await init(await compiled('@jsquash/webp/codec/dec/webp_dec.wasm'));
    return decode;
  },
};

const exifOf = (bytes: Uint8Array, kind: FileKind | undefined): ExifTags => {
  if (kind !== 'jpeg') return {};
  try {
    return exifTags(new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength));
  } catch (error) {
    if (error instanceof RangeError) return {}; // invalid metadata counts as missing
    throw error;
  }
};

/**
 * Decodes an image file.
 * @throws {FileError} if the file is no PNG, JPEG or WebP, or is damaged
 */
export async function pictureIn(bytes: Uint8Array, path: string): Promise<PictureFile> {
  const kind = fileKind(bytes);
  const load = kind && decoders[kind];
  if (!load) {
    throw new FileError(
      path,
      kind === 'heic'
        ? 'is a HEIC photo, which cannot be read; save it as JPEG.'
        : 'is no PNG, JPEG or WebP; save it as one of these.',
    );
  }
  const damaged = 'is damaged; save it again.';
  if (!isWhole(bytes, kind)) throw new FileError(path, damaged);
  const decode = await load();
  try {
    const {width, height, data} = await decode(new Uint8Array(bytes).buffer);
    const {orientation = 1, f35} = exifOf(bytes, kind);
    const pixels = upright({width, height, data}, orientation);
    return {pixels, ...(f35 !== undefined && {f35})};
  } catch (cause) {
    throw new FileError(path, damaged, {cause});
  }
}

/** Encodes pixels as a PNG file. */
export async function pngOf({width, height, data}: PhotoPixels): Promise<Uint8Array> {
  const {default: encode, init} = await import('@jsquash/png/encode.js');
  await init(await compiled('@jsquash/png/codec/pkg/squoosh_png_bg.wasm'));
  const image = {width, height, data: new Uint8ClampedArray(data), colorSpace: 'srgb' as const};
  return new Uint8Array(await encode(image as ImageData));
}
