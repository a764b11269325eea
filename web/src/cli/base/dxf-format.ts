/** Flags for the dialect and unit of DXF files. */
import {dxfStyles, dxfUnits, type DxfFormat} from '../../model/base/dxf-format.js';
import {choice, UsageError, type Arguments} from './arguments.js';

const [styleFlag, unitFlag] = ['--dxf-style', '--dxf-unit'] as const;

export const dxfFlags: readonly string[] = [styleFlag, unitFlag];

/**
 * @param isWritten the command writes a DXF file
 * @param writer the flags that make it write one, for messages
 * @throws {UsageError} for an unknown style or unit, and without a DXF file
 */
export function dxfFormat(args: Arguments, isWritten: boolean, writer = '--dxf FILE'): DxfFormat {
  const style = choice(args, styleFlag, dxfStyles);
  const unit = choice(args, unitFlag, dxfUnits);
  const [given] = dxfFlags.filter((flag) => args.value(flag) !== undefined);
  if (given !== undefined && !isWritten) {
    throw new UsageError(`${given} belongs to ${writer}, which is missing.`);
  }
  return {...(style && {style}), ...(unit && {unit})};
}
