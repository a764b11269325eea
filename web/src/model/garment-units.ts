/** The unit of a garment file. */
import {unitsInMetre, type FileUnit} from './garment-document.js';
import {fieldOf} from './read.js';

/** The same file with its numbers taken in another unit. @param text of a readable file */
export function inUnit(text: string, unit: FileUnit): string {
  const garment = JSON.parse(text) as object;
  const stated = fieldOf(garment, 'properties');
  const properties = {...(stated as object | undefined), units_in_meter: unitsInMetre[unit]};
  return JSON.stringify({...garment, properties});
}
