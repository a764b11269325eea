import type {Texts} from '../../texts/texts.js';
import {kindOf} from '../print/read-picture.js';
import type {PhotoSize} from './lattice-lines.js';

/** Kinds that browsers decode; of others it is said what they are. */
const decodable: ReadonlySet<string> = new Set(['png', 'jpeg', 'webp', 'avif', 'gif', 'bmp']);

/** The size of a picture as the browser shows it, or why it shows none. */
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
