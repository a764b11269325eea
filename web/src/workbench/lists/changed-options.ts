/** Changes of the solver's options that the user makes for one seam or one piece. */
import {angleOf, type GrainLock, type GrainRule} from '../../model/garment/grain.js';
import type {SolveOptions} from '../../model/design/options.js';
import type {PieceNames} from '../../model/garment/piece-names.js';
import type {SeamRow} from './rows.js';
import type {Workbench} from '../workbench.js';

export const matches = ['double', 'full', 'half', 'none'] as const;
type Match = (typeof matches)[number];

const weights = {double: 2, full: 1, half: 0.5} as const;

/** Returns undefined for any other weight. */
export function matchOf({matched, weight}: Pick<SeamRow, 'matched' | 'weight'>): Match | undefined {
  if (!matched) return 'none';
  return matches.find((match) => match !== 'none' && weights[match] === weight);
}

const without = <Value>(
  all: Readonly<Record<string, Value>> | undefined,
  key: string | number,
): Record<string, Value> =>
  Object.fromEntries(Object.entries(all ?? {}).filter(([name]) => name !== String(key)));

/** Omits a weight that equals the one in the garment file. */
export function withMatch(
  options: SolveOptions,
  {seam, ownWeight}: Pick<SeamRow, 'seam' | 'ownWeight'>,
  match: Match,
): SolveOptions {
  const others = (options.unmatched ?? []).filter((number) => number !== seam);
  if (match === 'none') return {...options, unmatched: [...others, seam]};
  const weight = weights[match];
  const rest = without(options.weights, seam);
  return {
    ...options,
    unmatched: others,
    weights: weight === ownWeight ? rest : {...rest, [seam]: weight},
  };
}

/** Keeps the grain line that was set for the piece. */
export function withGrain(
  options: SolveOptions,
  piece: string,
  grain: GrainLock | 'all',
): SolveOptions {
  const rest = without(options.grain?.pieces, piece);
  const angleDeg = angleOf(options.grain?.pieces?.[piece]);
  const rule =
    angleDeg === undefined ? grain : grain === 'all' ? {angleDeg} : {lock: grain, angleDeg};
  const pieces = rule === 'all' ? rest : {...rest, [piece]: rule};
  return {...options, grain: {...options.grain, pieces}};
}

/** Turns a piece by 90 degrees on the fabric: across the grain, or back along it. */
export function withQuarterTurn(options: SolveOptions, piece: string): SolveOptions {
  const rule = options.grain?.pieces?.[piece];
  const own = typeof rule === 'object' ? rule.lock : rule;
  const isAcross = (own ?? options.grain?.default) === 'across';
  return withGrain(options, piece, isAcross ? 'on' : 'across');
}

/** Sets the grain lines of pieces. @param lines direction by piece name, face up [degrees] */
export function withGrainLines(
  options: SolveOptions,
  lines: Readonly<Record<string, number>>,
): SolveOptions {
  const before = options.grain?.pieces ?? {};
  const said = Object.entries(lines).map(([piece, angleDeg]): [string, GrainRule] => {
    const rule = Object.hasOwn(before, piece) ? before[piece] : undefined;
    const own = typeof rule === 'string' ? {lock: rule} : rule;
    return [piece, {...own, angleDeg}];
  });
  return {
    ...options,
    grain: {...options.grain, pieces: {...before, ...Object.fromEntries(said)}},
  };
}

export function withPrinted(options: SolveOptions, piece: string, printed: boolean): SolveOptions {
  const others = (options.plain ?? []).filter((name) => name !== piece);
  return {...options, plain: printed ? others : [...others, piece]};
}

export const withoutPin = (options: SolveOptions, piece: string): SolveOptions => ({
  ...options,
  pins: without(options.pins, piece),
});

/** Renames a piece; an empty name restores the original one. */
export const withName = (
  names: PieceNames | undefined,
  piece: string,
  name: string,
): PieceNames => {
  const rest = without(names, piece);
  return name === '' ? rest : {...rest, [piece]: name};
};

// Turns a piece by 90 degrees on the fabric, for keys and buttons.

/** @returns true if there is such a piece */
export function turnPiece(workbench: Workbench, piece: number): boolean {
  const {design} = workbench.history;
  const {scenes} = workbench.sheet;
  const turned = scenes?.now.pieces[piece];
  if (!design || !turned) return false;
  workbench.history.change({options: withQuarterTurn(design.options, turned.name)});
  const {lists} = workbench.preferences.texts;
  workbench.notices.say({tone: 'info', text: lists.turned(turned.label), undo: true});
  return true;
}
