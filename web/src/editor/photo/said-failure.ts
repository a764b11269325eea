import type {Failure} from '../../model/failure.js';
import {photoFaults} from '../../model/photo.js';
import type {PhotoTexts} from '../../texts/photo-texts.js';

/** In the language of the page, where it is one of photographs. */
export function saidFailure({faults}: PhotoTexts, {reason, message}: Failure): string {
  const fault = photoFaults.find((known) => known === reason);
  return fault ? faults[fault] : message;
}
