/** Reads a file as the image of a print; the message for any other file names its kind. */
import type {PhotoSize} from '../photo/lattice-lines.js';
import {fileKind, isWhole, type FileKind} from '../image/file-kind.js';
import {dataUrlOf} from '../image/data-url.js';
import {hasOutsidePictures} from '../image/svg-picture.js';
import {sizedSvg} from '../image/printed-size.js';
import type {Texts} from '../texts/en.js';
import {loadPicture} from './picture-pixels.js';
import {pictureEndings} from './openable-files.js';

type Words = Texts['print']['files'];

const mostBytes = 12 * 2 ** 20;
/** Greatest length of the longer side. [px] */
const mostPixels = 8192;
/** Length of the head of a file that identifies its kind. [bytes] */
const beginning = 4096;

/** Kinds that can become prints. */
const pictureTypes: Readonly<Partial<Record<FileKind, string>>> = {
  ...{png: 'image/png', jpeg: 'image/jpeg', webp: 'image/webp', svg: 'image/svg+xml'},
};

interface OpenedPicture {
  /** A `data:` URL. */
  readonly image: string;
  /** [px] */
  readonly width: number;
  readonly height: number;
}

/** Returns whether a file is an image, by its first bytes or its name. */
export async function looksLikePicture(file: File): Promise<boolean> {
  const ending = file.name.slice(file.name.lastIndexOf('.') + 1).toLowerCase();
  const isCalledSo = file.type.startsWith('image/') || pictureEndings.includes(ending);
  return isCalledSo || (await kindOf(file)) !== undefined;
}

/** Returns the kind of a file by its first bytes; undefined if it is no image and no document. */
export const kindOf = async (file: Blob): Promise<FileKind | undefined> =>
  fileKind(new Uint8Array(await file.slice(0, beginning).arrayBuffer()));

/** Reads an image. @throws {Error} with one sentence that names the kind of file and a remedy */
export async function readPicture(file: File, words: Words): Promise<OpenedPicture> {
  const {name} = file;
  const kind = await kindOf(file);
  const type = kind && pictureTypes[kind];
  if (kind && !type) throw new Error(words.wrongKind(name, words.kinds[kind]));
  if (file.size > mostBytes) throw new Error(words.tooLarge(name));
  if (!kind || !type) throw new Error(words.unreadable(name));
  const damaged = new Error(words.damaged(name, words.kinds[kind]));
  const bytes = new Uint8Array(await file.arrayBuffer());
  if (!isWhole(bytes, kind)) throw damaged;
  const image = await dataUrlOf(
    kind === 'svg' ? svgBlob(bytes, name, words) : new Blob([bytes], {type}),
  );
  const picture = await loadPicture(image).catch(() => {
    throw damaged;
  });
  const {naturalWidth: width, naturalHeight: height} = picture;
  if (Math.max(width, height) > mostPixels) throw new Error(words.tooWide(name));
  return {image, width, height};
}

function svgBlob(bytes: Uint8Array, name: string, words: Words): Blob {
  const text = new TextDecoder().decode(bytes);
  if (hasOutsidePictures(text)) throw new Error(words.outsidePictures(name));
  return new Blob([sizedSvg(text)], {type: 'image/svg+xml'});
}

/** Kinds that browsers decode; the message for any other kind names it. */
const decodable: ReadonlySet<string> = new Set(['png', 'jpeg', 'webp', 'avif', 'gif', 'bmp']);

/**
 * Returns the size of an image as the browser shows it, or a message if the browser cannot show it.
 */
export async function shownPicture(
  picture: Blob,
  {address, name}: {readonly address: string; readonly name: string},
  files: Words,
): Promise<PhotoSize | string> {
  const image = new Image();
  image.src = address;
  const [kind, isShown] = await Promise.all([
    kindOf(picture),
    image.decode().then(
      () => true,
      () => false,
    ),
  ]);
  if (isShown) return {width: image.naturalWidth, height: image.naturalHeight};
  if (kind === undefined) return files.unreadable(name);
  return decodable.has(kind)
    ? files.damaged(name, files.kinds[kind])
    : files.wrongKind(name, files.kinds[kind]);
}
