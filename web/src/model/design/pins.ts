/** Pins of pieces that share symmetries: places of pieces that the user has chosen. */
import type {Alignment, MirrorMap, Point} from '../geometry/vectors.js';
import {inverse, mirrorAlignment, mirrors} from '../print/mirror-images.js';
import {nearestMirrored, type AngleRule} from '../print/mirror-lines.js';
import type {SolveOptions} from './options.js';
import type {Pattern} from '../result/result.js';
import type {Repeat} from '../print/wallpaper.js';

/** A symmetry of face-up pieces: from the first piece to the second, p' = R F p + t. */
export interface Mirroring {
  /** Names of the pieces, equal for a piece that is symmetric in itself. */
  readonly pieces: readonly [string, string];
  readonly map: MirrorMap;
}

type Pins = NonNullable<SolveOptions['pins']>;

/** Facts about a piece, apart from its symmetries. */
export interface PieceFacts {
  /** Centre of the piece; prints are turned about it. */
  readonly middle: Point;
  /** Angles that its grain allows; any angle without a rule. */
  readonly rule?: AngleRule | undefined;
}

const isSingle = ({pieces: [first, second]}: Mirroring): boolean => first === second;

export function mirroringsOf({
  pieces,
  symmetries,
}: Pick<Pattern, 'symmetries'> & {
  readonly pieces: readonly {readonly name: string}[];
}): readonly Mirroring[] {
  const name = (piece: number): string => pieces[piece]?.name ?? '';
  return symmetries.map((one): Mirroring => ({
    pieces:
      one.kind === 'piece'
        ? [name(one.piece), name(one.piece)]
        : [name(one.pieces[0]), name(one.pieces[1])],
    map: one.map,
  }));
}

export const ownMirroring = (
  mirrorings: readonly Mirroring[],
  name: string,
): Mirroring | undefined => mirrorings.find((one) => isSingle(one) && one.pieces[0] === name);

/** The other piece of a pair, and the map to it. */
function twinOf(
  mirrorings: readonly Mirroring[],
  name: string,
): {readonly name: string; readonly map: MirrorMap} | undefined {
  for (const one of mirrorings) {
    const [first, second] = one.pieces;
    if (isSingle(one)) continue;
    if (first === name) return {name: second, map: one.map};
    if (second === name) return {name: first, map: inverse(one.map)};
  }
  return undefined;
}

/**
 * The possible place of a piece nearest to `wanted`. All places are possible unless the piece is
 * symmetric in itself.
 */
export function nearestPlace(
  repeat: Repeat,
  mirrorings: readonly Mirroring[],
  name: string,
  wanted: Alignment,
  {middle, rule}: PieceFacts,
): Alignment {
  const own = ownMirroring(mirrorings, name);
  return (own && nearestMirrored(repeat, own.map, wanted, middle, rule)) ?? wanted;
}

/** Adds a pin and removes the pin of the mirror image, which would contradict or repeat it. */
export function withPin(
  pins: Pins | undefined,
  mirrorings: readonly Mirroring[],
  name: string,
  alignment: Alignment,
): Pins {
  const twin = twinOf(mirrorings, name)?.name;
  const others = Object.entries(pins ?? {}).filter(([other]) => other !== twin);
  return {...Object.fromEntries(others), [name]: alignment};
}

/** The same pins, with symmetric pieces moved to the nearest places that keep them symmetric. */
export function keptPins(
  repeat: Repeat,
  mirrorings: readonly Mirroring[],
  pins: Pins,
  factsOf: (name: string) => PieceFacts,
): Pins {
  const moved = Object.entries(pins).flatMap(([name, pin]) => {
    const own = ownMirroring(mirrorings, name);
    if (!own || mirrors(repeat, own.map, pin, pin)) return [];
    const at = nearestPlace(repeat, mirrorings, name, pin, factsOf(name));
    return at === pin ? [] : [[name, at] as const];
  });
  return moved.length === 0 ? pins : {...pins, ...Object.fromEntries(moved)};
}

/** Pairs with two pins that are not each other's mirror image. */
export const contradictions = (
  repeat: Repeat,
  mirrorings: readonly Mirroring[],
  pins: Pins,
): readonly Mirroring[] =>
  mirrorings.filter((one) => {
    const [first, second] = one.pieces.map((name) => pins[name]);
    return !isSingle(one) && first && second && !mirrors(repeat, one.map, first, second);
  });

/**
 * Place of a piece by its own pin, or as the mirror image of its pinned twin; undefined for a free
 * piece.
 */
export function pinnedPlace(
  repeat: Repeat,
  mirrorings: readonly Mirroring[],
  pins: Pins | undefined,
  name: string,
  like: Alignment,
): Alignment | undefined {
  const own = pins?.[name];
  if (own || !pins) return own;
  const twin = twinOf(mirrorings, name);
  const pin = twin && pins[twin.name];
  return pin && mirrorAlignment(repeat, inverse(twin.map), pin, like);
}
