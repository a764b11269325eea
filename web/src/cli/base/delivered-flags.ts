/** Fabric as delivered, from flags: its shrinkage, and its repeat as measured. */
import {deliveredIn, isSameFabric, shrinkageLimits} from '../../model/print/as-sewn.js';
import type {Delivered} from '../../model/print/repeating-print.js';
import {readPrintFile} from '../../model/print/read-print-file.js';
import {textOf} from '../../node/files.js';
import {UsageError, type Arguments} from './arguments.js';

const number = /^-?\d{1,4}(\.\d{1,6})?$/;

/** Two numbers with a sign between them; undefined for anything else. */
function pairIn(value: string, between: string): readonly [number, number] | undefined {
  const [one = '', other = '', ...more] = value.split(between);
  const isPair = more.length === 0 && number.test(one) && number.test(other);
  return isPair ? [Number(one), Number(other)] : undefined;
}

function shrinkageIn(args: Arguments): Delivered['shrinkage'] {
  const value = args.value('--shrinkage');
  if (value === undefined) return undefined;
  const [least, most] = shrinkageLimits;
  const pair = pairIn(value, ',');
  if (pair?.every((percent) => percent >= least && percent <= most)) {
    return {warp: pair[0], weft: pair[1]};
  }
  throw new UsageError(
    `--shrinkage is '${value}', but must be two numbers from ${least} to ${most}, along warp and weft in per cent, such as 3,1.5.`,
  );
}

function measuredIn(args: Arguments): Delivered['measured'] {
  const value = args.value('--measured');
  if (value === undefined) return undefined;
  const pair = pairIn(value, 'x');
  if (pair?.every((cm) => cm > 0)) return {across: pair[0], up: pair[1]};
  throw new UsageError(
    `--measured is '${value}', but must be the repeat in cm, across and up the fabric, such as 10.1x9.8.`,
  );
}

/**
 * The fabric by the flags; undefined if they leave it to the print file.
 * @throws {UsageError} for invalid values, or if the print file states others
 */
export function deliveredFor(
  args: Arguments,
  print: {readonly path: string; readonly bytes: Uint8Array},
): Delivered | undefined {
  const [shrinkage, measured] = [shrinkageIn(args), measuredIn(args)];
  if (!shrinkage && !measured) return undefined;
  const own = deliveredIn(readPrintFile(textOf(print.bytes), print.path)) ?? {};
  const given = {
    ...own,
    ...(shrinkage && {shrinkage}),
    ...(measured && {measured}),
  };
  for (const [flag, name] of [
    ['--shrinkage', 'shrinkage'],
    ['--measured', 'measured'],
  ] as const) {
    const [stated, wanted] = [own[name], given[name]];
    if (stated && !isSameFabric({[name]: stated}, {[name]: wanted})) {
      throw new UsageError(
        `${flag} contradicts the ${name} of the fabric in ${print.path}; leave one of them out.`,
      );
    }
  }
  return given;
}
