/** Changes of the solver's options that the user makes for one seam or one piece. */
import {angleOf, type GrainLock, type GrainRule} from '../../model/garment/grain.js';
import type {SolveOptions} from '../../model/design/options.js';
import type {PieceNames} from '../../model/garment/piece-names.js';
import type {SeamRow} from './rows.js';
import type {Workbench} from '../workbench.js';

/** Decisions on how much a seam counts; `usual`: as much as it is seen at its place. */
export type Importance = 'first' | 'well' | 'usual' | 'hardly' | 'none';

/** As visible as a centre front, and far more or less than that. */
const weights = {first: 10, well: 3, hardly: 0.5} as const;

/** @returns undefined for a weight of another file, or several */
export function importanceOf(
  {weights: own = {}, unmatched = []}: SolveOptions,
  seams: readonly Pick<SeamRow, 'seam'>[],
): Importance | undefined {
  const all = seams.map(({seam}): Importance | undefined => {
    if (unmatched.includes(seam)) return 'none';
    const weight = own[seam];
    if (weight === undefined) return 'usual';
    return (['first', 'well', 'hardly'] as const).find((one) => weights[one] === weight);
  });
  return all.every((one) => one === all[0]) ? all[0] : undefined;
}

/** @param seams numbers of seams in the garment file */
export function withImportance(
  options: SolveOptions,
  seams: readonly number[],
  importance: Importance,
): SolveOptions {
  const others = (options.unmatched ?? []).filter((number) => !seams.includes(number));
  const rest = Object.fromEntries(
    Object.entries(options.weights ?? {}).filter(([seam]) => !seams.includes(Number(seam))),
  );
  if (importance === 'none')
    return {...options, weights: rest, unmatched: [...others, ...seams].sort((a, b) => a - b)};
  if (importance === 'usual') return {...options, unmatched: others, weights: rest};
  const own = seams.map((seam): [number, number] => [seam, weights[importance]]);
  return {...options, unmatched: others, weights: {...rest, ...Object.fromEntries(own)}};
}

const without = <Value>(
  all: Readonly<Record<string, Value>> | undefined,
  key: string | number,
): Record<string, Value> =>
  Object.fromEntries(Object.entries(all ?? {}).filter(([name]) => name !== String(key)));

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
