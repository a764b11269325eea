import {Autosave, type StorageTrouble} from '../../../../web/src/app/storage/autosave.js';

declare global {
  /** The storage under test, and the troubles it reported. */
  var Storing: {readonly autosave: Autosave; readonly troubles: StorageTrouble[]};
}

const troubles: StorageTrouble[] = [];
globalThis.Storing = {
  troubles,
  autosave: new Autosave((trouble, isLoss) => {
    if (isLoss) troubles.push(trouble);
  }),
};
