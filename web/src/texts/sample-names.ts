/** Names of a sample garment's pieces and seams in the user's language. */
import type {DraftedEdge, GarmentDocument} from '../model/garment/garment-document.js';
import type {Texts} from './texts.js';

type SampleTexts = Pick<Texts, 'samples' | 'lists'>;

/** The name of a print, translated if it is a sample. */
export const printName = (
  {title, sample}: {readonly title: string; readonly sample?: {readonly name: string} | undefined},
  {samples}: Pick<Texts, 'samples'>,
): string => samples.prints[sample?.name ?? '']?.replaceAll(softHyphen, '') ?? title;

/** Place in a name of a print where a narrow gallery may break it; it is not part of the name. */
const softHyphen = '\u00ad';

/** The name of a sample print with soft hyphens, for a gallery. */
export const printCaption = (
  {name, title}: {readonly name: string; readonly title: string},
  {samples}: Pick<Texts, 'samples'>,
): string => samples.prints[name] ?? title;

/** A name of a sample, such as "Front left" or "Side seam, left", without its side, and the side. */
const sided = /^(.*?)(?:,? (left|right))?$/;

/** Sides within a name: "Devant [gauche/droit]". A name without a side has neither. */
const sideForms = / ?\[([^/\]]*)\/([^\]]*)\]/;

/** Style of a sample garment from the name of its file, which an edit of the garment keeps. */
const styleOf = (file: string): string => file.replace(/-[a-z]+\.json$/, '');

/** @param label name of the piece in the file of the sample */
function pieceName(
  style: string,
  label: string,
  {samples: {pieces}}: SampleTexts,
): string | undefined {
  const [, stem = '', side] = sided.exec(label) ?? [];
  const name = pieces[`${style}: ${stem}`] ?? pieces[stem];
  return name?.replace(sideForms, (_, left: string, right: string) =>
    side === undefined ? '' : ` ${side === 'left' ? left : right}`,
  );
}

/** @param name name of the seam in the file of the sample */
function seamName(name: string, {samples: {seams}, lists}: SampleTexts): string | undefined {
  const [, stem = '', side] = sided.exec(name) ?? [];
  const words = seams[stem];
  if (words === undefined || side === undefined) return words;
  return lists.onSide[side === 'left' ? 'left' : 'right'](words);
}

/** The edge without its name. */
function unnamed(edge: DraftedEdge): DraftedEdge {
  const copy: DraftedEdge & {label?: string} = {...edge};
  delete copy.label;
  return copy;
}

const known = new WeakMap<GarmentDocument, {readonly texts: SampleTexts; shown: GarmentDocument}>();

/**
 * Translates the title and the names of a sample garment. Edges lose their names, so that views
 * name them by their place. Other garments, and samples in English, are returned unchanged, and the
 * same arguments return the same object.
 * @param file name of the garment's file
 */
export function withSampleNames(
  garment: GarmentDocument,
  file: string,
  texts: SampleTexts,
): GarmentDocument {
  const style = styleOf(file);
  const title = texts.samples.garments[style];
  if (title === undefined) return garment;
  const before = known.get(garment);
  if (before?.texts === texts) return before.shown;
  const shown: GarmentDocument = {
    ...garment,
    title,
    pieces: garment.pieces.map((piece) => {
      const label = pieceName(style, piece.label ?? '', texts) ?? piece.label;
      return {
        ...piece,
        outline: piece.outline.map(unnamed),
        ...(label !== undefined && {label}),
      };
    }),
    seams: garment.seams.map((seam) => {
      const name = seamName(seam.name ?? '', texts) ?? seam.name;
      return {...seam, ...(name !== undefined && {name})};
    }),
  };
  known.set(garment, {texts, shown});
  return shown;
}
