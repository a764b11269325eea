/** A result as production takes it: the same bytes wherever the same problem was solved. */
import {sha256} from '@noble/hashes/sha2.js';
import {bytesToHex, utf8ToBytes} from '@noble/hashes/utils.js';

import type {SolveResult} from './result.js';

/** Times are what differs from run to run. */
export function withoutTimes(result: SolveResult): SolveResult {
  const milliseconds = {alignment: 0, deformation: 0, total: 0};
  return {...result, metrics: {...result.metrics, milliseconds}};
}

/**
 * The text of a result file without what differs between places: times are 0, and the notes, which call
 * files by their names, are left out. Browser and Node write the same bytes.
 */
export const resultText = (result: SolveResult): string =>
  `${JSON.stringify({...withoutTimes(result), notes: undefined, noteDetails: undefined})}\n`;

/** In lower-case hexadecimal digits. Here because pages without https have no `crypto.subtle`. */
export const sha256Of = (content: string | Uint8Array): string =>
  bytesToHex(sha256(typeof content === 'string' ? utf8ToBytes(content) : content));
