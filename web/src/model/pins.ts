/** Pins of pieces that share symmetries: where a piece goes when somebody wants it there. */
import type {Alignment, MirrorMap, Point} from './geometry.js';
import {inverse, mirrorAlignment, mirrors} from './mirror-images.js';
import {nearestMirrored, type AngleRule} from './mirror-lines.js';
import type {SolveOptions} from './options.js';
import type {Pattern} from './result.js';
import type {Repeat} from './wallpaper.js';

/** A symmetry of the garment as it lies: from the first piece to the second, p' = R F p + t. */
export interface Mirroring {
  /** By name; a piece that is symmetric in itself is both. */
  readonly pieces: readonly [string, string];
  readonly map: MirrorMap;
}

type Pins = NonNullable<SolveOptions['pins']>;

/** What is to be known of a piece besides its symmetries. */
export interface PieceFacts {
  /** Prints are turned about it. */
  readonly middle: Point;
  /** What its grain allows; any angle without one. */
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

/** The nearest place to `wanted` at which a piece can lie: all places, unless it is symmetric in itself. */
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

/** The newest pin counts: that of a mirror image would be against it, or say the same. */
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

/** Pairs of which both are pinned, but not as each other's mirror image. */
export const contradictions = (
  repeat: Repeat,
  mirrorings: readonly Mirroring[],
  pins: Pins,
): readonly Mirroring[] =>
  mirrorings.filter((one) => {
    const [first, second] = one.pieces.map((name) => pins[name]);
    return !isSingle(one) && first && second && !mirrors(repeat, one.map, first, second);
  });

/** How a piece lies by its own pin or, as the mirror image, by that of its twin; undefined when it is free. */
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
