/** What a person needs who places the print: loaded only then. */
import {defineParts} from '../parts.js';
import {register} from '../register.js';
import {PlaceBar} from './place-bar.js';

export function definePlacing(): void {
  defineParts();
  register('sw-place-bar', PlaceBar);
}
