import '../../../../web/src/element/auto.js';
import {sequence as run} from './sequences.js';

/** Resources that the graphics card holds for the whole document. */
declare global {
  var heldByCard: () => Promise<{readonly geometries: number; readonly textures: number}>;
  var sequence: typeof run;
}

globalThis.heldByCard = async () => {
  const {enter} = await import('../../../../web/src/viewer/stage.js');
  const nothing = (): void => undefined;
  const unseen = {
    ...{isAside: true, isSeen: false, hasSize: false, raster: {width: 1, height: 1, ratio: 1}},
    ...{draw: nothing, arrange: nothing, hang: nothing, copy: nothing, paint: nothing},
    ...{lost: nothing, mayBeHidden: nothing},
  };
  const stage = enter(unseen);
  const {geometries, textures} = stage.renderer.info.memory;
  stage.leave(unseen);
  return {geometries, textures};
};

globalThis.sequence = run;
