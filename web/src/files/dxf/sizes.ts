/** Selects the size of every piece. */
import {FileError} from '../../model/base/versioned-file.js';
import type {DxfPiece} from './pieces.js';

interface ChosenSize {
  readonly sizes: readonly string[];
  readonly sampleSize?: string;
  readonly size?: string;
  readonly pieces: readonly DxfPiece[];
}

const same = (one: string | undefined, other: string | undefined): boolean =>
  one?.trim().toUpperCase() === other?.trim().toUpperCase();

/**
 * Selects a size.
 * @param stated sample size in the file, from which other sizes were graded
 * @param wanted the size requested by the user
 * @throws {FileError} if the size does not exist
 */
export function chooseSize(
  all: readonly DxfPiece[],
  {
    stated,
    wanted,
    file,
  }: {
    readonly stated?: string | undefined;
    readonly wanted?: string | undefined;
    readonly file: string;
  },
): ChosenSize {
  const sizes = all.reduce<string[]>(
    (list, {size}) =>
      size === undefined || list.some((one) => same(one, size)) ? list : [...list, size],
    [],
  );
  const sample = sizes.find((size) => same(size, stated)) ?? stated ?? markedSize(all);
  if (wanted !== undefined && !sizes.some((size) => same(size, wanted)) && !same(sample, wanted)) {
    const known = sizes.length > 0 ? `it has ${sizes.join(', ')}` : 'it has one without a name';
    throw new FileError(file, `has no size '${wanted}'; ${known}.`);
  }
  const size = sizes.find((one) => same(one, wanted)) ?? sample;
  return {
    sizes,
    ...(sample !== undefined && {sampleSize: sample}),
    ...(size !== undefined && {size}),
    pieces: piecesIn(all, size, sample),
  };
}

/** The only size of a nest with a quantity, otherwise the middle size. */
function markedSize(all: readonly DxfPiece[]): string | undefined {
  const marked = all.find(
    ({size, text}) => size !== undefined && text.value('quantity') !== undefined,
  );
  const sized = all.filter(({size}) => size !== undefined);
  return (marked ?? sized[Math.floor((sized.length - 1) / 2)])?.size;
}

/** Pieces of one name are sizes of one piece, unless two have the same size. */
function piecesIn(
  all: readonly DxfPiece[],
  size: string | undefined,
  sample: string | undefined,
): DxfPiece[] {
  const nests = new Map<string, DxfPiece[]>();
  for (const piece of all) nests.set(piece.name, [...(nests.get(piece.name) ?? []), piece]);
  return [...nests.values()].flatMap((nest) => {
    const base = nest.find((piece) => same(piece.size, sample));
    const own = nest.filter((piece) => piece.size === undefined || same(piece.size, size));
    const taken = own.length > 0 ? own : [base ?? nest[Math.floor((nest.length - 1) / 2)]];
    return taken.flatMap((piece) => (piece ? [withWordsOf(piece, base)] : []));
  });
}

/** Copies the quantity of the sample size, the only one in a nest that states it. */
const withWordsOf = (piece: DxfPiece, base: DxfPiece | undefined): DxfPiece =>
  base && piece.text.value('quantity') === undefined ? {...piece, quantity: base.quantity} : piece;
