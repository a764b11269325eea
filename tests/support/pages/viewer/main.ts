import {PatternView, type PatternViewOptions} from '../../../../web/src/viewer/pattern-view.js';
import {realigned, type PatternScene} from '../../../../web/src/scene/scene.js';
import {Screen} from '../../../../web/src/viewer/screen.js';
import {SeamStrip} from '../../../../web/src/viewer/seam-strip.js';
import {loadTile, svgTile} from '../../../../web/src/image/tile.js';

/** Position and size of an element on the page. [CSS px] */
export interface Box {
  readonly left?: number;
  readonly top?: number;
  readonly width: number;
  readonly height: number;
}

declare global {
  /** The view under test, its scene, and functions to change it. */
  var Viewer: {
    readonly view: PatternView;
    scene: PatternScene | undefined;
    readonly realigned: typeof realigned;
    /** Opens a view of one seam, in a separate box over the other. */
    readonly openStrip: (width: number, height: number) => SeamStrip;
    /** Opens another view, in a separate box over the first. */
    readonly openView: (box: Box, options?: PatternViewOptions) => PatternView;
    /** Attaches a client to the shared renderer that never draws. */
    readonly openScreen: () => Screen;
    /** Number of images still to be read back from the graphics card. */
    reading: number;
    /** True if the page handles a press itself. */
    takesPress: boolean;
    readonly loadTile: typeof loadTile;
    readonly svgTile: typeof svgTile;
  };
}

const host = document.querySelector('main');
if (!host) throw new Error('The page has no main element.');

function boxed({left = 0, top = 0, width, height}: Box): HTMLElement {
  const box = document.createElement('div');
  const sides = Object.entries({left, top, width, height}).map(([side, px]) => [side, `${px}px`]);
  const style = {position: 'absolute', background: '#fbfaf8', overflow: 'hidden'};
  Object.assign(box.style, style, Object.fromEntries(sides));
  document.body.append(box);
  return box;
}

const {prototype: context} = WebGL2RenderingContext;
for (const [name, step] of [
  ['fenceSync', 1],
  ['deleteSync', -1],
] as const) {
  const method = Reflect.get(context, name) as (...given: unknown[]) => unknown;
  Reflect.set(context, name, function (this: unknown, ...given: unknown[]) {
    Viewer.reading += step;
    return Reflect.apply(method, this, given);
  });
}

globalThis.Viewer = {
  view: new PatternView(host, {onPress: () => Viewer.takesPress}),
  openStrip: (width, height) => new SeamStrip(boxed({width, height})),
  openView: (box, options) => new PatternView(boxed(box), options),
  openScreen: () => {
    const nothing = (): void => undefined;
    return new Screen(document.createElement('div'), {resized: nothing, draw: nothing}, 'aside');
  },
  takesPress: false,
  reading: 0,
  scene: undefined,
  ...{realigned, loadTile, svgTile},
};
