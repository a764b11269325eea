/** A result for production: equal bytes wherever the same problem is solved. */
import {sha256} from '@noble/hashes/sha2.js';
import {bytesToHex, utf8ToBytes} from '@noble/hashes/utils.js';

import type {SolveResult} from '../result/result.js';

/** Removes the times, the only part that differs from run to run. */
export function withoutTimes(result: SolveResult): SolveResult {
  const milliseconds = {alignment: 0, deformation: 0, total: 0};
  return {...result, metrics: {...result.metrics, milliseconds}};
}

/**
 * The text of a result file without the parts that differ between places: times are 0, and notes
 * are omitted, because they contain file names. Browser and Node write the same bytes.
 */
export const resultText = (result: SolveResult): string =>
  `${JSON.stringify({...withoutTimes(result), notes: undefined, noteDetails: undefined})}\n`;

/**
 * Hash in lower-case hexadecimal digits. It does not use `crypto.subtle`, which pages without https
 * lack.
 */
export const sha256Of = (content: string | Uint8Array): string =>
  bytesToHex(sha256(typeof content === 'string' ? utf8ToBytes(content) : content));
