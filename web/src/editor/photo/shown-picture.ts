import type {Texts} from '../../texts/texts.js';
import {kindOf} from '../print/read-picture.js';
import type {PhotoSize} from './lattice-lines.js';

/** Kinds that browsers decode; the message for any other kind names it. */
const decodable: ReadonlySet<string> = new Set(['png', 'jpeg', 'webp', 'avif', 'gif', 'bmp']);

/**
 * Returns the size of an image as the browser shows it, or a message if the browser cannot show it.
 */
export async function shownPicture(
  picture: Blob,
  {address, name}: {readonly address: string; readonly name: string},
  files: Texts['print']['files'],
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
