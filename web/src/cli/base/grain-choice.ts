/** The choice of a grain line for pieces on which the maker draws several. */
import type {GarmentDocument} from '../../model/garment/garment-document.js';
import {grainDeg, type GrainRule} from '../../model/garment/grain.js';
import {UsageError} from './arguments.js';

/**
 * Grain rules by piece from values such as `front=Bias` or `front=2`, by the name or the number of
 * a line.
 * @throws {UsageError} for an unknown piece or line, listing those that exist
 */
export function grainChoices(
  {pieces}: Pick<GarmentDocument, 'pieces'>,
  values: readonly string[],
): Readonly<Record<string, {readonly angleDeg: number}>> {
  return Object.fromEntries(
    values.map((value) => {
      const cut = value.lastIndexOf('=');
      const [name, wanted] = [value.slice(0, cut), value.slice(cut + 1)];
      if (cut < 1 || wanted === '')
        throw new UsageError(`--grain-line is '${value}', but must be PIECE=LINE.`);
      const piece = pieces.find((one) => one.name === name);
      if (!piece) {
        const known = pieces.map((one) => one.name).join(', ');
        throw new UsageError(`--grain-line names no piece '${name}'; there are ${known}.`);
      }
      const {grains = []} = piece;
      const line =
        grains.find((one) => one.name?.toLowerCase() === wanted.toLowerCase()) ??
        grains[/^\d+$/.test(wanted) ? Number(wanted) - 1 : -1];
      if (!line) {
        const known = grains.map((one, k) => one.name ?? String(k + 1)).join(', ');
        throw new UsageError(
          grains.length === 0
            ? `--grain-line: piece '${name}' has no choice of grain lines; set its angle with --options.`
            : `--grain-line: piece '${name}' has no line '${wanted}'; there are ${known}.`,
        );
      }
      return [name, {angleDeg: grainDeg(line)}];
    }),
  );
}

/** The options with these grain lines; each piece keeps its lock. Invalid JSON is unchanged. */
export function withGrainChoices(
  options: string,
  chosen: Readonly<Record<string, {readonly angleDeg: number}>>,
): string {
  if (Object.keys(chosen).length === 0) return options;
  try {
    const given = JSON.parse(options) as {
      readonly grain?: {readonly pieces?: Readonly<Record<string, GrainRule>>};
    };
    const pieces = {...given.grain?.pieces};
    for (const [name, line] of Object.entries(chosen)) {
      const before = pieces[name];
      pieces[name] = {...(typeof before === 'string' ? {lock: before} : before), ...line};
    }
    return JSON.stringify({...given, grain: {...given.grain, pieces}});
  } catch {
    return options;
  }
}
