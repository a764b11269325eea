import {PatternView} from '../../../web/src/viewer/pattern-view.js';
import type {PatternScene} from '../../../web/src/viewer/scene.js';
import {realigned} from '../../../web/src/viewer/scene.js';
import {SeamStrip} from '../../../web/src/viewer/seam-strip.js';
import {loadTile, svgTile} from '../../../web/src/viewer/tile.js';

declare global {
  /** The view under test, the scene it shows, and what it takes to change that. */
  var Viewer: {
    readonly view: PatternView;
    scene: PatternScene | undefined;
    readonly realigned: typeof realigned;
    /** A view of one seam, in a box of its own over the other. */
    readonly openStrip: (width: number, height: number) => SeamStrip;
    /** Whether the page follows a press itself. */
    takesPress: boolean;
    readonly loadTile: typeof loadTile;
    readonly svgTile: typeof svgTile;
  };
}

const host = document.querySelector('main');
if (!host) throw new Error('The page has no main element.');
globalThis.Viewer = {
  view: new PatternView(host, {onPress: () => Viewer.takesPress}),
  openStrip: (width, height) => {
    const box = document.createElement('div');
    Object.assign(box.style, {
      ...{position: 'absolute', left: '0', top: '0', background: '#fbfaf8'},
      width: `${width}px`,
      height: `${height}px`,
    });
    document.body.append(box);
    return new SeamStrip(box);
  },
  takesPress: false,
  scene: undefined,
  ...{realigned, loadTile, svgTile},
};
