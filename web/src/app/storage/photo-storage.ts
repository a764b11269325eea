/** Storage of photos in this browser. */
import type {PhotoKeeper} from '../../photo/photo-keeper.js';
import {keepPhoto, keptPhoto} from './kept-photos.js';
import {forgetUnfinished, keepUnfinished, unfinished} from './unfinished-photo.js';

export const photoStorage: PhotoKeeper = {
  ...{keep: keepPhoto, kept: keptPhoto},
  ...{keepUnfinished, unfinished, forgetUnfinished},
};
