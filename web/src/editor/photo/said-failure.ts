import type {Failure} from '../../model/failure.js';
import {photoFaults} from '../../model/photo.js';
import type {PhotoTexts} from '../../texts/photo-texts.js';

/** Returns the message of a failure, in the page's language for a failure of the photo reader. */
export function saidFailure({faults}: PhotoTexts, {reason, message}: Failure): string {
  const fault = photoFaults.find((known) => known === reason);
  return fault ? faults[fault] : message;
}
